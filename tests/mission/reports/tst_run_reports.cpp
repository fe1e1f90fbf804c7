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
