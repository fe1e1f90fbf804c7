#include <limits>

#include <QTest>

#include "core/campaign/comparison/pairing.h"
#include "tests/campaign/comparison/example_runs.h"
#include "tests/suite/suite.h"

namespace tst_pairing {

using namespace usar::campaign;
using usar::test::run;
using enum Outcome;

namespace {

RunFigures elsewhere(RunFigures figures) {
    figures.mission = "attic";
    return figures;
}

Metric metricFor(UnfinishedRuns unfinished) {
    Metric metric;
    metric.key = "duration_s";
    metric.unfinished = unfinished;
    return metric;
}

} // namespace

class tst_Pairing : public QObject {
    Q_OBJECT
private slots:
    void aPairHasTheSameMissionAndSeed() {
        const std::vector<RunFigures> runs{
            run("old", 3), elsewhere(run("new", 1)), run("new", 1), run("other", 1), run("old", 1),
            run("new", 3), elsewhere(run("old", 1))};
        const Pairing pairing = pairUp(runs, "old", "new").value();
        QCOMPARE(pairing.missions, (std::vector<std::string>{"attic", "quick_scan"}));
        QCOMPARE(pairing.pairs.size(), std::size_t{3});
        for (const RunPair& pair : pairing.pairs) {
            QCOMPARE(pair.baseline->variant, std::string("old"));
            QCOMPARE(pair.candidate->variant, std::string("new"));
            QCOMPARE(pair.baseline->pair, pair.candidate->pair);
            QCOMPARE(pair.baseline->mission, pair.candidate->mission);
            QCOMPARE(pairing.missions[static_cast<std::size_t>(pair.mission)], pair.baseline->mission);
        }
        QCOMPARE(pairing.single + pairing.not_counted + pairing.repeated, std::size_t{0});
    }

    void nothingIsMissingWithoutACount() {
        const std::vector<RunFigures> runs{run("old", 1),         run("new", 1),          run("new", 1, Failed),
                                           run("old", 2),         run("old", 3, Refused), run("new", 3),
                                           run("old", 4),         run("new", 4, Killed),  run("new", 5),
                                           run("old", 6, Failed), run("new", 6, Crashed)};
        const Pairing pairing = pairUp(runs, "old", "new").value();
        QCOMPARE(pairing.pairs.size(), std::size_t{2});
        QCOMPARE(pairing.pairs[0].candidate->outcome, Done); // the first run of a seed stands
        QCOMPARE(pairing.single, std::size_t{2});
        QCOMPARE(pairing.not_counted, std::size_t{2});
        QCOMPARE(pairing.repeated, std::size_t{1});
    }

    void anUnknownVariantIsRefusedWithThoseThereAre() {
        const std::vector<RunFigures> runs{run("old", 1), run("new", 1)};
        const auto refused = pairUp(runs, "old", "newer");
        QVERIFY(!refused);
        QCOMPARE(refused.error().where, std::string("newer"));
        QCOMPARE(refused.error().mend, std::string("Those that were flown: old, new"));
        QVERIFY(!pairUp({}, "old", "new"));
        QVERIFY(!pairUp(runs, "old", "old"));
    }

    void anUnfinishedRunContributesWhatTheMetricSays_data() {
        QTest::addColumn<Outcome>("outcome");
        QTest::addColumn<double>("limit"); // -1: nothing, in all columns
        QTest::addColumn<double>("measured");
        QTest::addColumn<double>("left_out");
        QTest::newRow("done") << Done << 80.0 << 80.0 << 80.0;
        QTest::newRow("failed") << Failed << 300.0 << 80.0 << -1.0;
        QTest::newRow("crashed") << Crashed << 300.0 << 80.0 << -1.0;
        QTest::newRow("timed out") << TimedOut << 300.0 << 80.0 << -1.0;
        QTest::newRow("out of memory") << OutOfMemory << 300.0 << 80.0 << -1.0;
        QTest::newRow("refused") << Refused << -1.0 << -1.0 << -1.0;
        QTest::newRow("killed") << Killed << -1.0 << -1.0 << -1.0;
    }
    void anUnfinishedRunContributesWhatTheMetricSays() {
        QFETCH(Outcome, outcome);
        RunFigures figures = run("old", 1, outcome);
        figures.metrics["duration_s"] = 80.0;
        const auto value = [&](UnfinishedRuns unfinished) {
            return valueOf(figures, metricFor(unfinished)).value_or(-1.0);
        };
        QTEST(value(UnfinishedRuns::CountTheLimit), "limit");
        QTEST(value(UnfinishedRuns::AsMeasured), "measured");
        QTEST(value(UnfinishedRuns::LeftOut), "left_out");
    }

    void withoutALimitAFailedRunHasNoTime() {
        RunFigures figures = run("old", 1, Failed);
        figures.time_limit_s = std::nullopt;
        QVERIFY(!valueOf(figures, metricFor(UnfinishedRuns::CountTheLimit)));
    }

    void withoutALimitAFailedRunCountsTheLongestTimeOfItsMission() {
        std::vector<RunFigures> runs;
        for (std::size_t pair = 0; pair < 4; ++pair)
            for (const char* variant : {"old", "new"}) {
                runs.push_back(run(variant, pair, pair % 2 == 0 && runs.size() % 2 == 1 ? Failed : Done));
                runs.back().metrics["duration_s"] = 10.0 * static_cast<double>(runs.size()); // 10 to 80
                runs.back().time_limit_s = std::nullopt;
                runs.back().mission = pair < 2 ? "a" : "b";
            }
        const Metric metric = metricFor(UnfinishedRuns::CountTheLimit);
        PairedValues values = valuesOf(pairUp(runs, "old", "new").value(), metric);
        QCOMPARE(values.baseline, (std::vector<double>{10.0, 30.0, 50.0, 70.0}));
        QCOMPARE(values.candidate, (std::vector<double>{40.0, 40.0, 80.0, 80.0}));
        QCOMPARE(values.assumed, std::size_t{2});
        QCOMPARE(values.left_out, std::size_t{0});
        QCOMPARE(values.limits, std::optional(Interval{40.0, 80.0}));
        for (RunFigures& one : runs)
            if (one.mission == "b")
                one.outcome = Failed; // Nobody knows how long it takes.
        values = valuesOf(pairUp(runs, "old", "new").value(), metric);
        QCOMPARE(values.left_out, std::size_t{2});
        for (RunFigures& one : runs)
            one.time_limit_s = 300.0;
        values = valuesOf(pairUp(runs, "old", "new").value(), metric);
        QCOMPARE(values.candidate, (std::vector<double>{300.0, 40.0, 300.0, 300.0}));
        QCOMPARE(values.assumed, std::size_t{0});
        QVERIFY(!valuesOf(pairUp(runs, "old", "new").value(), metricFor(UnfinishedRuns::AsMeasured)).limits);
    }

    void whatIsNoNumberIsNoFigure() {
        RunFigures figures = run("old", 1);
        const Metric metric = metricFor(UnfinishedRuns::AsMeasured);
        QVERIFY(!valueOf(figures, metric));
        figures.metrics["duration_s"] = std::nullopt;
        QVERIFY(!valueOf(figures, metric));
        figures.metrics["duration_s"] = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!valueOf(figures, metric));
    }

    void aPairWithoutAFigureIsCounted() {
        std::vector<RunFigures> runs{run("old", 1), run("new", 1), run("old", 2), run("new", 2)};
        runs[0].metrics["duration_s"] = 10.0;
        runs[1].metrics["duration_s"] = 11.0;
        runs[2].metrics["duration_s"] = 12.0;
        const PairedValues values = valuesOf(pairUp(runs, "old", "new").value(), metricFor(UnfinishedRuns::AsMeasured));
        QCOMPARE(values.baseline, std::vector<double>{10.0});
        QCOMPARE(values.candidate, std::vector<double>{11.0});
        QCOMPARE(values.left_out, std::size_t{1});
    }
};

USAR_TEST(tst_Pairing)

} // namespace tst_pairing

#include "tst_pairing.moc"
