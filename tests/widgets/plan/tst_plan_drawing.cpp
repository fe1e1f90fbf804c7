#include <QTest>

#include "tests/suite/suite.h"
#include "tests/widgets/plan_samples.h"
#include "widgets/plan/plan_drawing.h"

namespace tst_plan_drawing {

using namespace usar;
using namespace usar::widgets;

namespace {

const std::string root = "/P:0/DC:0";

/// A drawing of the courier's plan, and how often it was laid out with the usual flow.
struct Drawn {
    PlanFlow usual = PlanFlow::Across;
    int layouts = 0;
    PlanDrawing drawing{[this] {
        ++layouts;
        return usual;
    }};

    Drawn() { static_cast<void>(drawing.setPlan(planOf(courier_plan))); }
    PlanNodeId node(const std::string& path) const { return drawing.tree().find(path); }
    QRectF box(PlanNodeId node) { return drawing.layout().box(drawing.tree(), node); }
    std::optional<QPointF> fold(PlanNodeId node, PlanNodeId held) {
        return drawing.refold(held, [&](PlanFolds& folds) { return folds.set(drawing.tree(), node, true), true; });
    }
};

} // namespace

class tst_PlanDrawing : public QObject {
    Q_OBJECT
private slots:
    void isLaidOutOnlyAfterAChange();
    void anotherPlanKeepsFoldsAndReturnsTheTreeBefore();
    void flowIsTheUsualOneUnlessChosen();
    void refoldTellsHowFarTheHeldCardMoved();
    void refoldWithoutChangeKeepsTheLayout();
    void sensesAreHitOnlyWhereTheyAreDrawn();
    void foldMarkIsAtTheRightOfTheTitle();
    void emptyPlanHasAnEmptyDrawing();
};

void tst_PlanDrawing::isLaidOutOnlyAfterAChange() {
    Drawn drawn;
    QCOMPARE(drawn.layouts, 0);
    QVERIFY(!drawn.drawing.layout().bounds().isEmpty());
    drawn.drawing.layout();
    QCOMPARE(drawn.layouts, 1);
    drawn.drawing.forgetSizes();
    drawn.drawing.layout();
    QCOMPARE(drawn.layouts, 2);
}

void tst_PlanDrawing::anotherPlanKeepsFoldsAndReturnsTheTreeBefore() {
    Drawn drawn;
    drawn.fold(drawn.node(root + "/DE:0"), {});
    const int size = drawn.drawing.tree().size();
    std::string text(courier_plan);
    text.replace(text.find("((grab"), 0, "((look Look))\n      ");
    const PlanTree before = drawn.drawing.setPlan(planOf(text));
    QCOMPARE(before.size(), size);
    QVERIFY(drawn.drawing.tree().size() > size);
    QVERIFY(drawn.drawing.folds().folded(drawn.drawing.tree(), drawn.node(root + "/DE:0")));
    const int once = drawn.drawing.tree().size();
    QCOMPARE(drawn.drawing.setSharing(PlanSharing::Expanded).size(), once);
    QVERIFY(drawn.drawing.tree().size() > once);
    drawn.drawing.forgetFolds();
    QVERIFY(!drawn.drawing.folds().folded(drawn.drawing.tree(), drawn.node(root + "/DE:0")));
}

void tst_PlanDrawing::flowIsTheUsualOneUnlessChosen() {
    Drawn drawn;
    QVERIFY2(!drawn.drawing.turn(), "it was not laid out yet");
    QCOMPARE(drawn.drawing.layout().flow(), PlanFlow::Across);
    drawn.usual = PlanFlow::Down;
    QCOMPARE(drawn.drawing.layout().flow(), PlanFlow::Across); // until somebody turns it
    QVERIFY(drawn.drawing.turn());
    QCOMPARE(drawn.drawing.layout().flow(), PlanFlow::Down);
    QVERIFY(!drawn.drawing.turn());
    drawn.drawing.setFlow(PlanFlow::Across);
    QVERIFY(drawn.drawing.turn());
    QCOMPARE(drawn.drawing.layout().flow(), PlanFlow::Across);
    drawn.drawing.setFlow(std::nullopt);
    QVERIFY(drawn.drawing.turn());
}

void tst_PlanDrawing::refoldTellsHowFarTheHeldCardMoved() {
    Drawn drawn;
    const PlanNodeId work = drawn.node(root + "/DE:1");
    const PlanNodeId rest = drawn.node(root + "/DE:2");
    QCOMPARE(drawn.fold(drawn.node(root + "/DE:0"), rest), std::optional(QPointF())); // never laid out before
    const QPointF before = drawn.box(rest).topLeft();
    const auto moved = drawn.fold(work, rest);
    QVERIFY(moved && moved->y() < 0.0);
    QCOMPARE(drawn.box(rest).topLeft(), before + *moved);
    QVERIFY(drawn.drawing.hides({work.value + 3}) && !drawn.drawing.hides(work));
    QCOMPARE(drawn.fold({0}, rest), std::optional(QPointF())); // now it is folded away itself
    QVERIFY(drawn.drawing.hides(rest));
}

void tst_PlanDrawing::refoldWithoutChangeKeepsTheLayout() {
    Drawn drawn;
    drawn.drawing.layout();
    QVERIFY(!drawn.drawing.refold({0}, [](PlanFolds&) { return false; }));
    QCOMPARE(drawn.layouts, 1);
}

void tst_PlanDrawing::sensesAreHitOnlyWhereTheyAreDrawn() {
    Drawn drawn;
    const PlanNodeId sense = drawn.node(root + "/DE:1/S:1");
    const QPointF there = drawn.box(sense).center();
    QCOMPARE(drawn.drawing.nodeAt(there, PlanDetail::Full), sense);
    QCOMPARE(drawn.drawing.nodeAt(there, PlanDetail::Names), drawn.node(root + "/DE:1"));
    QCOMPARE(drawn.drawing.nodeAt(drawn.drawing.layout().bounds().bottomRight() + QPointF(50, 50), PlanDetail::Full),
             PlanNodeId{});
}

void tst_PlanDrawing::foldMarkIsAtTheRightOfTheTitle() {
    Drawn drawn;
    const PlanNodeId work = drawn.node(root + "/DE:1");
    const QRectF box = drawn.box(work);
    const QPointF mark = box.topRight() + QPointF(-14, 12);
    QVERIFY(drawn.drawing.onFoldMark(work, mark, PlanDetail::Full));
    QVERIFY2(!drawn.drawing.onFoldMark(work, mark, PlanDetail::Names), "it is not drawn then");
    QVERIFY(!drawn.drawing.onFoldMark(work, box.topLeft() + QPointF(8, 12), PlanDetail::Full));
    const PlanNodeId sense = drawn.node(root + "/DE:1/S:1");
    QVERIFY(!drawn.drawing.onFoldMark(sense, mark, PlanDetail::Full));
}

void tst_PlanDrawing::emptyPlanHasAnEmptyDrawing() {
    PlanDrawing drawing([] { return PlanFlow::Down; });
    QVERIFY(drawing.tree().empty() && drawing.layout().bounds().isEmpty());
    QCOMPARE(drawing.nodeAt({5, 5}, PlanDetail::Full), PlanNodeId{});
    QCOMPARE(drawing.setPlan({}).size(), 0);
}

USAR_TEST(tst_PlanDrawing)

} // namespace tst_plan_drawing

#include "tst_plan_drawing.moc"
