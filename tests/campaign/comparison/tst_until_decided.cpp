#include <limits>

#include <QTest>

#include "core/campaign/comparison/until_decided.h"
#include "core/campaign/statistics/sequential_test.h"
#include "tests/campaign/comparison/example_runs.h"
#include "tests/suite/suite.h"

namespace tst_until_decided {

using namespace usar::campaign;
using usar::test::run;
using enum Outcome;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

RunFigures with(RunFigures figures, const std::string& key, double value) {
    figures.metrics[key] = value;
    return figures;
}

std::optional<double> gainOf(const RunFigures& baseline, const RunFigures& candidate, const std::string& key) {
    for (const Metric& metric : usualMetrics())
        if (metric.key == key)
            return scaledGain({&baseline, &candidate, 0}, metric);
    return std::nullopt;
}

} // namespace

class tst_UntilDecided : public QObject {
    Q_OBJECT
private slots:
    void successComesFirst_data() {
        QTest::addColumn<Outcome>("baseline");
        QTest::addColumn<Outcome>("candidate");
        QTest::addColumn<std::optional<double>>("gain");
        const std::optional<double> none;
        QTest::newRow("only the candidate is done") << Failed << Done << std::optional(infinite);
        QTest::newRow("only the baseline is done") << Done << Crashed << std::optional(-infinite);
        QTest::newRow("neither is done") << Failed << TimedOut << std::optional(0.0);
        QTest::newRow("one was killed") << Done << Killed << none;
        QTest::newRow("one was refused") << Refused << Done << none;
        QTest::newRow("both are done") << Done << Done << std::optional(-5.0);
    }
    void successComesFirst() {
        QFETCH(Outcome, baseline);
        QFETCH(Outcome, candidate);
        QFETCH(std::optional<double>, gain);
        QCOMPARE(gainOf(with(run("old", 1, baseline), "duration_s", 100.0),
                        with(run("new", 1, candidate), "duration_s", 110.0), "duration_s"),
                 gain);
    }

    void aGainHasTheGoodDirectionAndTheMarginAsItsUnit() {
        const auto gain = [](const std::string& key, double before, double after) {
            return gainOf(with(run("old", 1), key, before), with(run("new", 1), key, after), key).value_or(99.0);
        };
        QCOMPARE(gain("duration_s", 100.0, 98.0), 1.0);
        QCOMPARE(gain("coverage_pct", 98.0, 99.0), 2.0);
        QCOMPARE(gain("rmse_m", 0.3, 0.5), -4.0);
        QCOMPARE(gain("duration_s", 0.0, 0.0), 0.0);
    }

    void withoutAFigureThereIsNoGain() {
        QVERIFY(!gainOf(run("old", 1), with(run("new", 1), "duration_s", 3.0), "duration_s"));
    }

    void failuresDecideACampaign() {
        SequentialTest test(1.0);
        for (std::size_t pair = 0; pair < 20; ++pair)
            test.add(gainOf(run("old", pair), run("new", pair, Failed), "duration_s").value());
        QCOMPARE(test.verdict(), SequentialVerdict::Worse);
    }

    void resultsMayComeInAnyOrder() {
        const auto resultOf = [](int pair, const char* variant, double duration_s) {
            RunResult result;
            result.pair = pair;
            result.variant = variant;
            result.summary = {{"duration_s", duration_s}};
            return result;
        };
        DecisionWatch watch("old", "new");
        for (int pair = 29; pair > 0; --pair) {
            watch.take(resultOf(pair, "new", 80.0));
            watch.take(resultOf(pair, "old", 100.0));
        }
        watch.take(resultOf(0, "third", 100.0));
        watch.take(resultOf(0, "new", 80.0));
        QCOMPARE(watch.pairs(), std::size_t(0)); // The first pair is not complete.
        QCOMPARE(watch.verdict(), SequentialVerdict::Undecided);
        watch.take(resultOf(0, "old", 100.0));
        QCOMPARE(watch.pairs(), std::size_t(30));
        QCOMPARE(watch.verdict(), SequentialVerdict::Better);
    }
};

USAR_TEST(tst_UntilDecided)

} // namespace tst_until_decided

#include "tst_until_decided.moc"
