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

    void numbersOfAReasonDoNotMatter_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("without");
        QTest::newRow("none") << "It fell."
                              << "It fell.";
        QTest::newRow("a fraction") << "at 3.25 s."
                                    << "at # s.";
        QTest::newRow("a sign") << "It hovers at x -0.1 m, y 12 m; wait."
                                << "It hovers at x # m, y # m; wait.";
        QTest::newRow("a sign at the beginning") << "-3 m"
                                                 << "# m";
        QTest::newRow("a range") << "from 3-5 s"
                                 << "from #-# s";
        QTest::newRow("a hyphen") << "a take-off at 3"
                                  << "a take-off at #";
        QTest::newRow("a name") << "R1 met R12 at 3 s"
                                << "R1 met R12 at # s";
        QTest::newRow("a letter before a fraction") << "x0.5 m"
                                                    << "x# m";
    }
    void numbersOfAReasonDoNotMatter() {
        QFETCH(QString, text);
        QTEST(QString::fromStdString(withoutNumbers(text.toStdString())), "without");
    }

    void aGroupTellsWhereItsRunsEnded() {
        std::vector<RunFigures> runs{run("old", 1, Failed), run("new", 1, Failed), run("new", 2, Failed),
                                     run("old", 2),         run("new", 3, Failed), run("old", 3)};
        runs[0].course.path = {{0.0, 0.0}, {25.0, 25.0}};
        runs[1].course = {{}, {{0.0, 0.0}, {1.0, 1.0}}, {}, {{29.0, 21.0}}};
        runs[4].course.path = {{-0.5, 3.0}};
        const std::vector<FailureGroup> groups = failureGroups(compare(runs, "old", "new").value(), runs);
        QCOMPARE(groups.size(), std::size_t{1});
        const std::vector<FailurePlace>& places = groups[0].places;
        QCOMPARE(places.size(), std::size_t{3});
        QCOMPARE(wordsOf(places[0].place), std::string("around x 25 m, y 25 m"));
        QCOMPARE(places[0].of_baseline, std::size_t{1});
        QCOMPARE(places[0].of_candidate, std::size_t{1});
        QCOMPARE(wordsOf(places[1].place), std::string("around x -5 m, y 5 m"));
        QVERIFY(!places[2].place);
        QCOMPARE(places[2].of_candidate, std::size_t{1});
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
