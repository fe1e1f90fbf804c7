#include <QTest>

#include "core/campaign/comparison/failures.h"
#include "tests/campaign/comparison/example_runs.h"
#include "tests/suite/suite.h"

namespace tst_failures {

using namespace usar::campaign;
using usar::test::run;
using enum Outcome;

namespace {

RunFigures with(RunFigures figures, double duration_s, double coverage_pct) {
    figures.metrics = {{"duration_s", duration_s}, {"coverage_pct", coverage_pct}};
    return figures;
}

} // namespace

class tst_Failures : public QObject {
    Q_OBJECT
private slots:
    void theWorstComeFirst() {
        const std::vector<RunFigures> runs{
            with(run("old", 0), 90.0, 99.0),          with(run("new", 0), 95.0, 99.5),
            with(run("old", 1, Failed), 50.0, 80.0),  with(run("new", 1, Failed), 50.0, 10.0),
            with(run("old", 2, Crashed), 10.0, 90.0), with(run("new", 2), 20.0, 99.0),
            with(run("old", 3, Killed), 1.0, 0.0),    with(run("new", 3), 500.0, 0.0)};
        const Comparison comparison = compare(runs, "old", "new").value();
        std::vector<std::size_t> numbers;
        for (const RunFigures* one : worstRuns(comparison, 5))
            numbers.push_back(one->number);
        QCOMPARE(numbers, (std::vector<std::size_t>{4, 3, 2, 1, 0}));
        QCOMPARE(worstRuns(comparison, 100).size(), std::size_t{6});
    }

    void failuresOfOneReasonAreOneGroupWhateverTheirNumbers() {
        std::vector<RunFigures> runs{run("old", 1, Failed),  run("new", 1, Failed), run("new", 22, Failed),
                                     run("old", 2, Crashed), run("new", 3),         run("other", 4, Failed)};
        runs[3].reason = "Signal 11";
        const std::vector<FailureGroup> groups = failureGroups(compare(runs, "old", "new").value(), runs);
        QCOMPARE(groups.size(), std::size_t{2});
        QCOMPARE(groups[0].reason, std::string("The area was not covered after # s."));
        QCOMPARE(groups[0].of_baseline, std::size_t{1});
        QCOMPARE(groups[0].of_candidate, std::size_t{2});
        QCOMPARE(groups[0].example, &runs[0]);
        QCOMPARE(groups[1].reason, std::string("Signal #"));
        QCOMPARE(groups[1].outcome, Crashed);
    }
};

USAR_TEST(tst_Failures)

} // namespace tst_failures

#include "tst_failures.moc"
