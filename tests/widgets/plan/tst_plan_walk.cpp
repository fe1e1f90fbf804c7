#include <QTest>

#include "tests/suite/suite.h"
#include "tests/widgets/plan_samples.h"
#include "widgets/models/plan/plan_reasons.h"
#include "widgets/models/plan/plan_selection.h"

namespace tst_plan_walk {

using namespace usar;
using namespace usar::widgets;

namespace {

const std::string root = "/P:0/DC:0";
const std::string fetch = "/P:0/DC:0/DE:1/A:0/C:0";

} // namespace

class tst_PlanWalk : public QObject {
    Q_OBJECT
private slots:
    void stepsLeadToNeighbors_data();
    void stepsLeadToNeighbors();
    void firstStepLeadsToTheRoot();
    void nextGoesRound_data();
    void nextGoesRound();
    void selectionTellsWhetherItChanged();
    void selectionMovesToTheSamePart();
    void searchIsRememberedUntilTheTreeChanges();
    void nodeTextTellsAll();
    void reservationIsEmptyForACompleteDrawing();
};

void tst_PlanWalk::stepsLeadToNeighbors_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<int>("step");
    QTest::addColumn<QString>("to");
    const auto row = [](const char* name, const std::string& from, PlanStep step, const std::string& to) {
        QTest::newRow(name) << QString::fromStdString(from) << int(step) << QString::fromStdString(to);
    };
    row("into the collection: its first drive", root, PlanStep::In, root + "/DE:0");
    row("out of a drive", root + "/DE:1", PlanStep::Out, root);
    row("out of a sense: to its card", root + "/DE:1/S:1", PlanStep::Out, root + "/DE:1");
    row("down: the card's first sense", root + "/DE:1", PlanStep::After, root + "/DE:1/S:0");
    row("down: the next sense", root + "/DE:1/S:0", PlanStep::After, root + "/DE:1/S:1");
    row("down: past the last sense", root + "/DE:1/S:1", PlanStep::After, root + "/DE:2");
    row("up: the last sense of the card above", root + "/DE:2", PlanStep::Before, root + "/DE:1/S:1");
    row("up: from the first sense to its card", root + "/DE:1/S:0", PlanStep::Before, root + "/DE:1");
    row("down at the end", root + "/DE:2", PlanStep::After, "");
    row("up at the beginning", root + "/DE:0", PlanStep::Before, "");
    row("out of the root", root, PlanStep::Out, "");
    row("along a link", fetch + "/CE:1/A:0/AP:0/A:2/AP:1", PlanStep::In, root + "/DE:0/A:0/AP:1");
}

void tst_PlanWalk::stepsLeadToNeighbors() {
    QFETCH(QString, from);
    QFETCH(int, step);
    QFETCH(QString, to);
    const PlanTree tree(planOf(courier_plan));
    const PlanNodeId start = tree.find(from.toStdString());
    QVERIFY(start.valid());
    const PlanNodeId wanted = to.isEmpty() ? PlanNodeId{} : tree.find(to.toStdString());
    QVERIFY(to.isEmpty() || wanted.valid());
    QCOMPARE(planStep(tree, start, static_cast<PlanStep>(step)), wanted);
}

void tst_PlanWalk::firstStepLeadsToTheRoot() {
    const PlanTree tree(planOf(courier_plan));
    for (const PlanStep step : {PlanStep::Out, PlanStep::In, PlanStep::Before, PlanStep::After}) {
        QCOMPARE(planStep(tree, {}, step), PlanNodeId{0});
        QCOMPARE(planStep(PlanTree(), {}, step), PlanNodeId{});
    }
}

void tst_PlanWalk::nextGoesRound_data() {
    QTest::addColumn<int>("from");
    QTest::addColumn<bool>("backward");
    QTest::addColumn<int>("to");
    QTest::newRow("from nowhere") << -1 << false << 2;
    QTest::newRow("back from nowhere") << -1 << true << 9;
    QTest::newRow("from one of them") << 2 << false << 5;
    QTest::newRow("from between") << 3 << false << 5;
    QTest::newRow("back from between") << 6 << true << 5;
    QTest::newRow("around the end") << 9 << false << 2;
    QTest::newRow("around the beginning") << 2 << true << 9;
}

void tst_PlanWalk::nextGoesRound() {
    QFETCH(int, from);
    QFETCH(bool, backward);
    QFETCH(int, to);
    const std::vector<PlanNodeId> nodes{{2}, {5}, {9}};
    QCOMPARE(nextOf(nodes, {from}, backward), PlanNodeId{to});
    QCOMPARE(nextOf({}, {from}, backward), PlanNodeId{});
}

void tst_PlanWalk::selectionTellsWhetherItChanged() {
    PlanSelection selection;
    QCOMPARE(selection.node(), PlanNodeId{});
    QVERIFY(!selection.set({}));
    QVERIFY(selection.set({3}));
    QVERIFY(!selection.set({3}));
    QCOMPARE(selection.node(), PlanNodeId{3});
}

void tst_PlanWalk::selectionMovesToTheSamePart() {
    const PlanTree before(planOf(courier_plan));
    std::string text(courier_plan);
    text.replace(text.find("((grab"), 0, "((look Look))\n      ");
    const PlanTree edited(planOf(text));
    PlanSelection selection;
    selection.moveTo(edited, before);
    QCOMPARE(selection.node(), PlanNodeId{});
    selection.set(before.find(fetch + "/CE:3"));
    selection.moveTo(edited, before);
    QCOMPARE(edited[selection.node()].name, QStringLiteral("go"));
    const PlanTree expanded(planOf(courier_plan), PlanSharing::Expanded);
    const std::string brake = fetch + "/CE:1/A:0/AP:0/A:2/AP:1/A:1";
    selection.set(expanded.find(brake));
    selection.moveTo(before, expanded);
    QCOMPARE(selection.node(), before.find(brake));
    selection.moveTo(PlanTree(), before);
    QCOMPARE(selection.node(), PlanNodeId{});
}

void tst_PlanWalk::searchIsRememberedUntilTheTreeChanges() {
    const PlanTree tree(planOf(courier_plan));
    PlanSelection selection;
    selection.search(tree, QStringLiteral("distance"));
    const auto found = selection.found();
    QCOMPARE(found.size(), std::size_t(3));
    QCOMPARE(selection.foundByNode().size(), static_cast<std::size_t>(tree.size()));
    QVERIFY(selection.foundByNode()[found[1].index()]);
    QVERIFY(!selection.foundByNode()[0] && !selection.isFound());
    QCOMPARE(selection.nextFound(false), found[0]);
    QCOMPARE(selection.nextFound(true), found[2]);
    selection.set(found[0]);
    QVERIFY(selection.isFound());
    QCOMPARE(selection.nextFound(false), found[1]);
    selection.search(tree, QStringLiteral("zebra"));
    QVERIFY(selection.found().empty() && selection.foundByNode().empty());
    QCOMPARE(selection.nextFound(false), PlanNodeId{});
    selection.search(tree, QStringLiteral("distance"));
    selection.moveTo(tree, tree);
    QVERIFY(selection.found().empty());
    QCOMPARE(selection.node(), found[0]);
}

void tst_PlanWalk::nodeTextTellsAll() {
    const PlanTree tree(planOf(courier_plan));
    PlanStates states;
    states.reset(tree);
    PlanFolds folds;
    PlanMark pinned;
    pinned.path = fetch + "/CE:0/S:0";
    pinned.words = QStringList{QStringLiteral("Pinned to true")};
    const PlanMarks marks(tree, {pinned});
    const auto text = [&](const std::string& path) {
        return planNodeText(tree, states, folds, marks, tree.find(path));
    };
    const QString grab = text(fetch + "/CE:0");
    for (const char* part :
         {"element grab", "at most 3 starts", "Priority 1", "only when near", "has not run yet", "Line 5"})
        QVERIFY2(grab.contains(QLatin1String(part)), qPrintable(grab));
    QVERIFY(!grab.contains(QStringLiteral("Folded parts")));
    folds.set(tree, tree.find(fetch + "/CE:0"), true);
    QVERIFY(text(fetch + "/CE:0").contains(QStringLiteral("Folded parts: 1")));
    QVERIFY(text(fetch + "/CE:1").contains(QStringLiteral("Priority 2, shared with others")));
    QVERIFY(text(pinned.path).contains(QStringLiteral("Not asked yet\nPinned to true")));
    QVERIFY(text(fetch + "/CE:1/A:0/AP:0/A:2/AP:1").contains(QStringLiteral("Drawn in full elsewhere")));
}

void tst_PlanWalk::reservationIsEmptyForACompleteDrawing() {
    const PlanTree tree(planOf(courier_plan));
    PlanStates states;
    states.reset(tree);
    QCOMPARE(planReservation(tree, states), QString());
    PlanSnapshot snapshot;
    snapshot.paths = std::make_shared<const std::vector<std::string>>(1, root + "/DE:9");
    snapshot.activities.resize(1);
    states.take(tree, snapshot);
    QVERIFY(planReservation(tree, states).contains(QStringLiteral("not in this plan: 1")));
}

USAR_TEST(tst_PlanWalk)

} // namespace tst_plan_walk

#include "tst_plan_walk.moc"
