#include <set>
#include <string>

#include <QTest>

#include "tests/suite/suite.h"
#include "tests/widgets/plan_samples.h"
#include "widgets/models/plan/plan_layout.h"
#include "widgets/models/plan/plan_tree.h"

namespace tst_plan_tree {

using namespace usar;
using namespace usar::widgets;

class tst_PlanTree : public QObject {
    Q_OBJECT
private slots:
    void everyPartHasItsPathKindAndPlace_data();
    void everyPartHasItsPathKindAndPlace();
    void pathsAndNodesAgree_data();
    void pathsAndNodesAgree();
    void referencesToTheSameFormAreDrawnOnce();
    void pathsThroughALinkLeadToTheDrawnPart();
    void expandedDrawsTheFormAtEachPlace();
    void equalsOfALevelShareItsPlace();
    void fragmentShowsAllItsForms();
    void unusedFormsStandBesideTheCollection();
    void circleOfReferencesEndsInALink();
    void doublingFormsAreGivenUpBeforeMemoryIs();
    void longChainsNeedNoStack();
    void searchFindsByNameKindAndDetail_data();
    void searchFindsByNameKindAndDetail();
    void foldsOutliveAnEdit();
    void namesakesFoldApart();
    void showOnlyOpensTheWay();
    void emptyPlanIsAnEmptyTree();
};

namespace {

QString nameAt(const PlanTree& tree, std::string_view path) {
    const PlanNodeId node = tree.find(path);
    return node.valid() ? tree[node].name : QStringLiteral("nothing");
}

} // namespace

void tst_PlanTree::everyPartHasItsPathKindAndPlace_data() {
    QTest::addColumn<std::string>("path");
    QTest::addColumn<PlanNodeKind>("kind");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("detail");
    QTest::addColumn<int>("line");
    const auto row = [](const char* spoken, const char* path, PlanNodeKind kind, const char* name, const char* detail,
                        int line) {
        QTest::newRow(spoken) << std::string(path) << kind << QString::fromUtf8(name) << QString::fromUtf8(detail)
                              << line;
    };
    using K = PlanNodeKind;
    row("collection", "/P:0/DC:0", K::Collection, "courier", "", 11);
    row("goal of the collection", "/P:0/DC:0/S:0", K::Sense, "Delivered", "", 11);
    row("drive with a frequency", "/P:0/DC:0/DE:0", K::Drive, "safety", "every 2 s", 13);
    row("first sense of a trigger", "/P:0/DC:0/DE:1/S:0", K::Sense, "Battery", "> 0.2", 14);
    row("second sense of a trigger", "/P:0/DC:0/DE:1/S:1", K::Sense, "Bumped", "= false", 14);
    row("competence with a limit", "/P:0/DC:0/DE:1/A:0/C:0", K::Competence, "fetch", "2 min at most", 3);
    row("goal of a competence", "/P:0/DC:0/DE:1/A:0/C:0/S:0", K::Sense, "Loaded", "", 3);
    row("element with retries", "/P:0/DC:0/DE:1/A:0/C:0/CE:0", K::Element, "grab", "at most 3 starts", 5);
    row("element counted over levels", "/P:0/DC:0/DE:1/A:0/C:0/CE:3", K::Element, "go", "", 7);
    row("act with arguments", "/P:0/DC:0/DE:1/A:0/C:0/CE:3/A:0", K::Act, "DriveTo(\"depot\", $speed=1.5)", "", 7);
    row("pattern", "/P:0/DC:0/DE:1/A:0/C:0/CE:1/A:0/AP:0", K::Pattern, "approach", "", 8);
    row("sense as a step", "/P:0/DC:0/DE:1/A:0/C:0/CE:1/A:0/AP:0/A:1", K::Sense, "Distance", "< 1.0", 8);
    row("pattern in a pattern", "/P:0/DC:0/DE:1/A:0/C:0/CE:1/A:0/AP:0/A:2/AP:1", K::Pattern, "halt", "", 9);
    row("reference without its form", "/P:0/DC:0/DE:1/A:0", K::Competence, "fetch", "2 min at most", 3);
    row("adopt", "/P:0/DC:0/DE:2/A:0/AD:0", K::Adopt, "wait", "", 10);
    row("what an adopt does", "/P:0/DC:0/DE:2/A:0/AD:0/A:0", K::Act, "Rest", "", 10);
}

void tst_PlanTree::everyPartHasItsPathKindAndPlace() {
    QFETCH(std::string, path);
    QFETCH(PlanNodeKind, kind);
    QFETCH(QString, name);
    QFETCH(QString, detail);
    QFETCH(int, line);
    const PlanTree tree(planOf(courier_plan), PlanSharing::Expanded);
    const PlanNodeId node = tree.find(path);
    QVERIFY(node.valid());
    QCOMPARE(tree[node].kind, kind);
    QCOMPARE(tree[node].name, name);
    QCOMPARE(tree[node].detail, detail);
    QCOMPARE(static_cast<int>(tree[node].at.line), line);
}

void tst_PlanTree::pathsAndNodesAgree_data() {
    QTest::addColumn<bool>("expanded");
    QTest::newRow("shared parts once") << false;
    QTest::newRow("shared parts everywhere") << true;
}

void tst_PlanTree::pathsAndNodesAgree() {
    QFETCH(bool, expanded);
    const PlanTree tree(planOf(courier_plan), expanded ? PlanSharing::Expanded : PlanSharing::Once);
    std::set<std::string> paths;
    for (const PlanNodeId node : tree.nodes()) {
        QCOMPARE(tree.find(tree.path(node)), node);
        QVERIFY(paths.insert(tree.path(node)).second);
        for (const PlanNodeId child : tree.children(node))
            QVERIFY(child > node && child < tree[node].end && tree[child].parent == node && !tree[child].in_card);
    }
    QCOMPARE(tree.find("/P:0/DC:0/DE:7"), PlanNodeId{});
    QCOMPARE(tree.find(""), PlanNodeId{});
    QCOMPARE(tree.find("/"), PlanNodeId{});
    QCOMPARE(tree.find("no path"), PlanNodeId{});
}

void tst_PlanTree::referencesToTheSameFormAreDrawnOnce() {
    const PlanTree tree(planOf(courier_plan));
    const PlanNodeId first = tree.find("/P:0/DC:0/DE:0/A:0/AP:1");
    const PlanNodeId again = tree.find("/P:0/DC:0/DE:1/A:0/C:0/CE:1/A:0/AP:0/A:2/AP:1");
    QCOMPARE(tree[first].link, PlanNodeId{});
    QCOMPARE(tree.children(first).size(), std::size_t(2));
    QCOMPARE(tree[again].link, first);
    QVERIFY(tree.children(again).empty());
    QVERIFY(!tree[again].recursive);
}

void tst_PlanTree::pathsThroughALinkLeadToTheDrawnPart() {
    const PlanTree tree(planOf(courier_plan));
    const PlanNodeId brake = tree.find("/P:0/DC:0/DE:0/A:0/AP:1/A:1");
    QCOMPARE(tree[brake].name, QStringLiteral("Brake"));
    QCOMPARE(tree.find("/P:0/DC:0/DE:1/A:0/C:0/CE:1/A:0/AP:0/A:2/AP:1/A:1"), brake);
    QCOMPARE(tree.find("/P:0/DC:0/DE:1/A:0/C:0/CE:1/A:0/AP:0/A:2/AP:1/A:2"), PlanNodeId{});
}

void tst_PlanTree::expandedDrawsTheFormAtEachPlace() {
    const PlanTree once(planOf(courier_plan));
    const PlanTree expanded(planOf(courier_plan), PlanSharing::Expanded);
    QCOMPARE(expanded.size(), once.size() + 2);
    for (const PlanNodeId node : expanded.nodes())
        QCOMPARE(expanded[node].link, PlanNodeId{});
    QCOMPARE(nameAt(expanded, "/P:0/DC:0/DE:1/A:0/C:0/CE:1/A:0/AP:0/A:2/AP:1/A:1"), QStringLiteral("Brake"));
}

void tst_PlanTree::equalsOfALevelShareItsPlace() {
    const PlanTree tree(planOf(courier_plan));
    const auto element = [&](int number) {
        return tree[tree.find("/P:0/DC:0/DE:1/A:0/C:0/CE:" + std::to_string(number))];
    };
    QCOMPARE(element(0).level, 0);
    QVERIFY(!element(0).has_equals);
    QCOMPARE(element(1).level, 1);
    QCOMPARE(element(2).level, 1);
    QVERIFY(element(1).has_equals && element(2).has_equals);
    QCOMPARE(element(3).level, 2);
}

void tst_PlanTree::fragmentShowsAllItsForms() {
    const PlanTree tree(planOf("((C top (elements ((a below)))) (AP below (X Y)) (AP alone (Z)))"));
    QCOMPARE(tree[PlanNodeId{0}].kind, PlanNodeKind::Plan);
    QCOMPARE(tree.children(PlanNodeId{0}).size(), std::size_t(2));
    QCOMPARE(nameAt(tree, "/P:0/C:0"), QStringLiteral("top"));
    QCOMPARE(nameAt(tree, "/P:0/AP:1"), QStringLiteral("alone"));
    QCOMPARE(nameAt(tree, "/P:0/C:0/CE:0/A:0/AP:0/A:1"), QStringLiteral("Y"));
}

void tst_PlanTree::unusedFormsStandBesideTheCollection() {
    const PlanTree tree(planOf("((AP spare (X)) (DC life (drives ((d Act)))))"));
    QCOMPARE(tree[PlanNodeId{0}].kind, PlanNodeKind::Plan);
    QCOMPARE(tree[tree.children(PlanNodeId{0})[0]].kind, PlanNodeKind::Collection);
    QCOMPARE(nameAt(tree, "/P:0/DC:0/DE:0/A:0"), QStringLiteral("Act"));
    QCOMPARE(nameAt(tree, "/P:0/AP:0/A:0"), QStringLiteral("X"));
}

void tst_PlanTree::circleOfReferencesEndsInALink() {
    for (const PlanSharing sharing : {PlanSharing::Once, PlanSharing::Expanded}) {
        const PlanTree tree(planOf("((AP a (X b)) (AP b (a Y)) (DC life (drives ((d a)))))"), sharing);
        const PlanNodeId again = tree.find("/P:0/DC:0/DE:0/A:0/AP:0/A:1/AP:1/A:0/AP:0");
        QVERIFY(again.valid());
        QVERIFY(tree[again].recursive);
        QCOMPARE(tree[again].link, tree.find("/P:0/DC:0/DE:0/A:0/AP:0"));
    }
}

void tst_PlanTree::doublingFormsAreGivenUpBeforeMemoryIs() {
    std::string text = "((AP p0 (X))";
    for (int i = 1; i < 60; ++i)
        text += "(AP p" + std::to_string(i) + " (p" + std::to_string(i - 1) + " p" + std::to_string(i - 1) + "))";
    text += "(DC life (drives ((d p59)))))";
    const PlanTree tree(planOf(text), PlanSharing::Expanded);
    QVERIFY(tree.truncated());
    QVERIFY(tree.size() < PlanTree::most_nodes + 1000);
    QVERIFY(!PlanTree(planOf(text), PlanSharing::Once).truncated());
}

void tst_PlanTree::longChainsNeedNoStack() {
    constexpr int length = 20'000;
    posh::Plan plan = planOf("((DC life (drives ((d p0)))))");
    for (int i = 0; i < length; ++i) {
        posh::Pattern pattern;
        pattern.name.text = "p" + std::to_string(i);
        pattern.steps.push_back(posh::Call{{"p" + std::to_string(i + 1), {}}, {}});
        plan.forms.push_back(pattern);
    }
    const PlanTree tree(plan, PlanSharing::Expanded);
    QCOMPARE(tree.size(), length + 3);
    const PlanNodeId last{tree.size() - 1};
    QCOMPARE(tree[last].kind, PlanNodeKind::Act);
    QCOMPARE(tree.find(tree.path(last)), last);
}

void tst_PlanTree::searchFindsByNameKindAndDetail_data() {
    QTest::addColumn<QString>("words");
    QTest::addColumn<QStringList>("found");
    const auto row = [](const char* spoken, const char* words, const char* found) {
        QTest::newRow(spoken) << QString::fromLatin1(words)
                              << QString::fromLatin1(found).split(u' ', Qt::SkipEmptyParts);
    };
    row("part of a name", "reste", "Rested");
    row("whatever the case", "CLOSEG", "CloseGripper");
    row("kind", "adopt", "wait");
    row("kind and name", "sense dist", "Distance Distance Distance");
    row("detail", "every", "safety");
    row("nothing like it", "zebra", "");
    row("no words", " ", "");
    row("kind in full", "action pattern", "halt approach halt");
}

void tst_PlanTree::searchFindsByNameKindAndDetail() {
    QFETCH(QString, words);
    QFETCH(QStringList, found);
    const PlanTree tree(planOf(courier_plan));
    QStringList names;
    for (const PlanNodeId node : tree.search(words))
        names << tree[node].name;
    QCOMPARE(names, found);
}

void tst_PlanTree::foldsOutliveAnEdit() {
    const PlanTree before(planOf(courier_plan));
    PlanFolds folds;
    folds.set(before, before.find("/P:0/DC:0/DE:1/A:0/C:0/CE:1"), true);
    std::string text(courier_plan);
    text.replace(text.find("((safety"), 0, "((first Honk))\n      ");
    text.replace(text.find("((grab"), 0, "((look Look))\n      ");
    const PlanTree after(planOf(text));
    QCOMPARE(nameAt(after, "/P:0/DC:0/DE:2/A:0/C:0/CE:2"), QStringLiteral("near"));
    for (const PlanNodeId node : after.nodes())
        QCOMPARE(folds.folded(after, node), after[node].name == u"near");
}

void tst_PlanTree::namesakesFoldApart() {
    const PlanTree tree(planOf("((DC life (drives ((d Act)) ((d Other)))))"));
    PlanFolds folds;
    folds.set(tree, tree.find("/P:0/DC:0/DE:1"), true);
    QVERIFY(!folds.folded(tree, tree.find("/P:0/DC:0/DE:0")));
    QVERIFY(folds.folded(tree, tree.find("/P:0/DC:0/DE:1")));
    QCOMPARE(tree.findKey(tree[tree.find("/P:0/DC:0/DE:1")].key), tree.find("/P:0/DC:0/DE:1"));
}

void tst_PlanTree::showOnlyOpensTheWay() {
    const PlanTree tree(planOf(courier_plan));
    const PlanNodeId brake = tree.find("/P:0/DC:0/DE:0/A:0/AP:1/A:1");
    PlanFolds folds;
    folds.showOnly(tree, {brake});
    for (PlanNodeId at = tree[brake].parent; at.valid(); at = tree[at].parent)
        QVERIFY(!folds.folded(tree, at));
    QVERIFY(folds.folded(tree, tree.find("/P:0/DC:0/DE:1")));
    QVERIFY(folds.reveal(tree, tree.find("/P:0/DC:0/DE:1/A:0")));
    QVERIFY(!folds.reveal(tree, tree.find("/P:0/DC:0/DE:1/A:0")));
    folds.unfoldAll();
    QCOMPARE(folds, PlanFolds());
}

void tst_PlanTree::emptyPlanIsAnEmptyTree() {
    const PlanTree tree{posh::Plan()};
    QVERIFY(tree.empty());
    QCOMPARE(tree.find("/P:0/DC:0"), PlanNodeId{});
    QVERIFY(tree.search(QStringLiteral("a")).empty());
}

USAR_TEST(tst_PlanTree)

} // namespace tst_plan_tree

#include "tst_plan_tree.moc"
