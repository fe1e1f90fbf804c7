// What usar-mission writes while a run lasts, and of one that never began.
#include <QTest>

#include "core/mission/reports/progress_bar.h"
#include "core/mission/runs/mission_runner.h"
#include "tests/suite/suite.h"

namespace tst_run_reports {

using namespace usar;
using namespace usar::mission;

namespace {

Progress at(double percent) {
    Progress progress;
    progress.percent = percent;
    progress.state = "scanning";
    return progress;
}

/// With 12 s of wall time left.
Progress allKnown() {
    Progress progress = at(40.0);
    progress.speed_x = 120.0;
    progress.coverage_pct = 37.0;
    progress.distance_m = 812.0;
    progress.elapsed = Seconds{960.0};
    progress.range_left_m = 310.0;
    return progress;
}

} // namespace

class tst_RunReports : public QObject {
    Q_OBJECT
private slots:
    void aTerminalHasOneBarThatIsDrawnAgain() {
        ProgressBar bar(true);
        for (const double percent : {0.0, 1.0, 1.0}) {
            const std::string written = bar.show(at(percent), Seconds{1.0});
            QCOMPARE(written, "\r" + progressLine(at(percent), Seconds{1.0}) + "\x1b[K");
        }
    }

    void aLineTellsWhatIsKnown_data() {
        QTest::addColumn<Progress>("progress");
        QTest::addColumn<QString>("end");
        const auto but = [](auto change) {
            Progress progress = at(40.0);
            progress.speed_x = 120.0;
            change(progress);
            return progress;
        };
        QTest::newRow("nothing more") << but([](Progress&) {}) << "scanning  120x  ETA 0:12";
        QTest::newRow("coverage is never rounded up")
            << but([](Progress& progress) { progress.coverage_pct = 99.9; }) << "ETA 0:12  99 % covered";
        QTest::newRow("distance") << but([](Progress& progress) { progress.distance_m = 812.3; })
                                  << "ETA 0:12  812 m traveled";
        QTest::newRow("elapsed") << but([](Progress& progress) { progress.elapsed = Seconds{960.0}; })
                                 << "ETA 0:12  16:00 elapsed";
        QTest::newRow("battery") << but([](Progress& progress) { progress.range_left_m = 310.0; })
                                 << "ETA 0:12  310 m range left";
        QTest::newRow("no number") << but([](Progress& progress) { progress.range_left_m = qQNaN(); }) << "ETA 0:12";
        QTest::newRow("all of it") << allKnown()
                                   << "ETA 0:12  37 % covered  812 m traveled  16:00 elapsed  310 m range left";
    }

    void aLineTellsWhatIsKnown() {
        QFETCH(Progress, progress);
        QFETCH(QString, end);
        const QString line = QString::fromStdString(progressLine(progress, Seconds{8.0}));
        QVERIFY2(line.endsWith(end), qPrintable(line));
    }

    /// A longer one would go on to the next row, and each drawing would leave a row behind.
    void aLineIsNoWiderThanTheTerminal_data() {
        QTest::addColumn<int>("columns");
        QTest::addColumn<QString>("line");
        const QString bar = "[########------------]  40 %  ";
        QTest::newRow("wide enough") << 200
                                     << bar + "scanning  120x  ETA 0:12  37 % covered  812 m traveled  16:00 elapsed"
                                              "  310 m range left";
        QTest::newRow("no figure is cut") << 80 << bar + "scanning  120x  ETA 0:12  37 % covered";
        QTest::newRow("the last one just fits") << 68 << bar + "scanning  120x  ETA 0:12  37 % covered";
        QTest::newRow("and here it does not") << 67 << bar + "scanning  120x  ETA 0:12";
        QTest::newRow("words are cut") << 34 << bar + "scan";
        QTest::newRow("no room") << 0 << "";
    }

    void aLineIsNoWiderThanTheTerminal() {
        QFETCH(int, columns);
        QFETCH(QString, line);
        QCOMPARE(QString::fromStdString(progressLine(allKnown(), Seconds{8.0}, std::size_t(columns))), line);
    }

    void charactersAreCountedAndNotBytes() {
        Progress progress;
        progress.state = "ééé";
        QCOMPARE(progressLine(progress, Seconds{1.0}, 32), "[--------------------]   0 %  éé");
    }

    void theLastColumnOfATerminalStaysFree() {
        ProgressBar bar(true);
        QCOMPARE(bar.show(allKnown(), Seconds{8.0}, 68), "\r" + progressLine(allKnown(), Seconds{8.0}, 67) + "\x1b[K");
        ProgressBar file(false);
        QCOMPARE(file.show(allKnown(), Seconds{8.0}, 68), progressLine(allKnown(), Seconds{8.0}) + "\n");
    }

    void textTakesThePlaceOfTheBar() {
        ProgressBar bar(true);
        QCOMPARE(bar.say("first"), std::string("first\n"));
        QVERIFY(!bar.show(at(5.0), Seconds{1.0}).empty());
        QCOMPARE(bar.say("over the bar"), std::string("\r\x1b[Kover the bar\n"));
        QCOMPARE(bar.say("below it"), std::string("below it\n"));
    }

    void aFileHasALineForEveryTenth() {
        ProgressBar bar(false);
        std::string written;
        for (const double percent : {0.0, 4.0, 9.9, 10.0, 19.0, 15.0, 42.0, 100.0})
            written += bar.show(at(percent), Seconds{1.0});
        std::string expected;
        for (const double percent : {0.0, 10.0, 42.0, 100.0})
            expected += progressLine(at(percent), Seconds{1.0}) + "\n";
        QCOMPARE(written, expected);
        QCOMPARE(bar.say("done"), std::string("done\n"));
    }

    void aRefusalTellsWhatIsKnown() {
        const Error error{"no", "here", "Mend it"};
        MissionOptions options;
        options.behavior = "airrobot/dance";
        options.seed = 5;
        Mission mission;
        mission.name = "Yard";
        mission.behavior = "airrobot/cpp";
        mission.plan = "a.lap";
        const RunSummary nothing = refusedRun(error);
        QCOMPARE(nothing.reason, std::string("here: no. Mend it."));
        QVERIFY(!nothing.success && nothing.mission.empty() && nothing.behavior.empty() && !nothing.seed);
        const RunSummary typed = refusedRun(error, &options);
        QCOMPARE(typed.behavior, std::string("airrobot/dance"));
        QVERIFY(typed.seed == std::uint64_t{5} && typed.mission.empty());
        const RunSummary read = refusedRun(error, &options, &mission);
        QCOMPARE(read.mission, std::string("Yard"));
        QCOMPARE(read.behavior, std::string("airrobot/cpp"));
        QCOMPARE(read.plan, std::string("a.lap"));
    }
};

USAR_TEST(tst_RunReports)

} // namespace tst_run_reports

#include "tst_run_reports.moc"
