#include <algorithm>
#include <random>
#include <string>

#include <QTest>

#include "tests/suite/suite.h"
#include "tests/widgets/plan_samples.h"
#include "widgets/models/plan/plan_layout.h"

namespace tst_plan_layout {

using namespace usar;
using namespace usar::widgets;

namespace {

const PlanMetrics metrics{[](const QString& text) { return 7.0 * double(text.size()); },
                          [](const QString& text) { return 6.0 * double(text.size()); }, 20.0};

struct Drawn {
    PlanTree tree;
    PlanFolds folds;
    PlanFlow flow = PlanFlow::Across;
    PlanLayout layout() const { return {tree, folds, measurePlan(tree, metrics), metrics.row_px, flow}; }
};

/// Competences with random numbers of elements, some of them equals, with senses.
posh::Plan randomPlan(unsigned seed) {
    std::mt19937 random(seed);
    const auto upTo = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
    std::string text = "(";
    const int forms = 6;
    for (int form = 0; form < forms; ++form) {
        text += "(C c" + std::to_string(form) + " (elements";
        for (int level = upTo(4); level >= 0; --level) {
            text += "(";
            for (int member = upTo(2); member >= 0; --member) {
                text += "(e" + std::to_string(level) + std::to_string(member) + " (trigger (";
                for (int sense = upTo(3); sense > 0; --sense)
                    text += "(Sense" + std::to_string(sense) + " 1.5 <)";
                text += ")) " + (form > 0 && upTo(1) ? "c" + std::to_string(upTo(form - 1)) : "Act") + ")";
            }
            text += ")";
        }
        text += "))";
    }
    return planOf(text + "(DC life (drives ((d c5)) ((f c4)) ((g c3)))))");
}

} // namespace

class tst_PlanLayout : public QObject {
    Q_OBJECT
private slots:
    void cardsNeverOverlap_data();
    void cardsNeverOverlap();
    void childrenStandInOrderBehindTheirParent();
    void foldingTakesAwayWhatIsBelow();
    void senseRowsLieInTheirCardInOrder();
    void everyCardAndRowIsHit();
    void rectangleGivesWhatItTouches();
    void sameInputGivesTheSamePicture();
    void outlineIsNarrowerThanTheBroadTree();
    void longNamesAreCut();
    void emptyTreeHasNoSize();
};

void tst_PlanLayout::cardsNeverOverlap_data() {
    QTest::addColumn<int>("flow");
    QTest::newRow("across") << static_cast<int>(PlanFlow::Across);
    QTest::newRow("outline") << static_cast<int>(PlanFlow::Down);
}

void tst_PlanLayout::cardsNeverOverlap() {
    QFETCH(int, flow);
    for (unsigned seed = 0; seed < 30; ++seed) {
        Drawn drawn{PlanTree(randomPlan(seed), PlanSharing::Expanded), {}, static_cast<PlanFlow>(flow)};
        std::mt19937 random(seed);
        for (int node = 0; node < drawn.tree.size(); node += 1 + static_cast<int>(random() % 17))
            drawn.folds.set(drawn.tree, {node}, true);
        const PlanLayout layout = drawn.layout();
        std::vector<QRectF> cards;
        for (const PlanNodeId node : drawn.tree.nodes())
            if (layout.shown(node))
                cards.push_back(layout.box(drawn.tree, node));
        for (std::size_t i = 0; i < cards.size(); ++i) {
            QVERIFY(layout.bounds().contains(cards[i]));
            for (std::size_t k = i + 1; k < cards.size(); ++k)
                QVERIFY(!cards[i].intersects(cards[k]));
        }
    }
}

void tst_PlanLayout::childrenStandInOrderBehindTheirParent() {
    const Drawn drawn{PlanTree(planOf(courier_plan)), {}};
    const PlanLayout layout = drawn.layout();
    for (const PlanNodeId node : drawn.tree.nodes()) {
        double bottom = -1.0;
        for (const PlanNodeId child : drawn.tree.children(node)) {
            const QRectF box = layout.box(drawn.tree, child);
            QVERIFY(box.left() > layout.box(drawn.tree, node).right());
            QVERIFY(box.top() > bottom);
            QCOMPARE(box.width(), layout.box(drawn.tree, drawn.tree.children(node)[0]).width());
            bottom = box.bottom();
        }
    }
}

void tst_PlanLayout::foldingTakesAwayWhatIsBelow() {
    Drawn drawn{PlanTree(planOf(courier_plan)), {}};
    const PlanNodeId work = drawn.tree.find("/P:0/DC:0/DE:1");
    const double whole_px = drawn.layout().bounds().height();
    drawn.folds.set(drawn.tree, work, true);
    const PlanLayout layout = drawn.layout();
    QVERIFY(layout.bounds().height() < whole_px);
    QVERIFY(layout.shown(work));
    QVERIFY(!layout.box(drawn.tree, {work.value + 1}).isNull()); // its trigger
    for (const PlanNodeId node : planNodes(work.value + 1, drawn.tree[work].end.value))
        QVERIFY(!layout.shown(node));
    QVERIFY(layout.shown(drawn.tree.find("/P:0/DC:0/DE:2/A:0/AD:0")));
}

void tst_PlanLayout::senseRowsLieInTheirCardInOrder() {
    const Drawn drawn{PlanTree(planOf(courier_plan)), {}};
    const PlanLayout layout = drawn.layout();
    const PlanNodeId work = drawn.tree.find("/P:0/DC:0/DE:1");
    QCOMPARE(drawn.tree[work].senses, 2);
    const QRectF card = layout.box(drawn.tree, work);
    const QRectF first = layout.box(drawn.tree, {work.value + 1});
    const QRectF second = layout.box(drawn.tree, {work.value + 2});
    QVERIFY(card.contains(first) && card.contains(second));
    QVERIFY(first.top() >= card.top() + metrics.row_px);
    QVERIFY(second.top() >= first.bottom());
}

void tst_PlanLayout::everyCardAndRowIsHit() {
    for (const PlanFlow flow : {PlanFlow::Across, PlanFlow::Down}) {
        const Drawn drawn{PlanTree(randomPlan(3), PlanSharing::Expanded), {}, flow};
        const PlanLayout layout = drawn.layout();
        for (const PlanNodeId node : drawn.tree.nodes()) {
            const QRectF box = layout.box(drawn.tree, node);
            const QPointF in_title(box.center().x(), box.top() + 8.0);
            QCOMPARE(layout.nodeAt(drawn.tree, in_title), node);
        }
        QCOMPARE(layout.nodeAt(drawn.tree, layout.bounds().topLeft() - QPointF(5, 5)), PlanNodeId{});
        QCOMPARE(layout.nodeAt(drawn.tree, layout.bounds().bottomRight() + QPointF(5, 5)), PlanNodeId{});
    }
}

void tst_PlanLayout::rectangleGivesWhatItTouches() {
    for (const PlanFlow flow : {PlanFlow::Across, PlanFlow::Down})
        for (unsigned seed = 0; seed < 10; ++seed) {
            const Drawn drawn{PlanTree(randomPlan(seed), PlanSharing::Expanded), {}, flow};
            const PlanLayout layout = drawn.layout();
            const QRectF all = layout.bounds();
            const QRectF area(all.width() * 0.3, all.height() * 0.4, all.width() * 0.25, all.height() * 0.2);
            const std::vector<PlanNodeId> found = layout.nodesIn(drawn.tree, area);
            QVERIFY(std::is_sorted(found.begin(), found.end()));
            for (const PlanNodeId node : drawn.tree.nodes())
                if (layout.shown(node) && layout.box(drawn.tree, node).intersects(area))
                    QVERIFY(std::binary_search(found.begin(), found.end(), node));
        }
}

void tst_PlanLayout::sameInputGivesTheSamePicture() {
    const Drawn drawn{PlanTree(randomPlan(7), PlanSharing::Expanded), {}};
    const PlanLayout a = drawn.layout();
    const PlanLayout b = drawn.layout();
    for (const PlanNodeId node : drawn.tree.nodes())
        QCOMPARE(a.box(drawn.tree, node), b.box(drawn.tree, node));
}

void tst_PlanLayout::outlineIsNarrowerThanTheBroadTree() {
    Drawn drawn{PlanTree(planOf(courier_plan)), {}};
    const QRectF broad = drawn.layout().bounds();
    drawn.flow = PlanFlow::Down;
    const QRectF outline = drawn.layout().bounds();
    QVERIFY(outline.width() < 0.5 * broad.width());
    QVERIFY(outline.height() > broad.height());
}

void tst_PlanLayout::longNamesAreCut() {
    const Drawn drawn{PlanTree(planOf("((DC life (drives ((d " + std::string(500, 'x') + ")))))")), {}};
    QVERIFY(drawn.layout().bounds().width() < 4.0 * plan_card::widest_px);
}

void tst_PlanLayout::emptyTreeHasNoSize() {
    const Drawn drawn{PlanTree(), {}};
    QVERIFY(drawn.layout().bounds().isNull());
    QCOMPARE(drawn.layout().nodeAt(drawn.tree, {0, 0}), PlanNodeId{});
}

USAR_TEST(tst_PlanLayout)

} // namespace tst_plan_layout

#include "tst_plan_layout.moc"
