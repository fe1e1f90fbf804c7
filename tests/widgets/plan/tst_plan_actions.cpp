// The commands of the plan editor by name and by keys.
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/plan/editor/plan_actions.h"

namespace tst_plan_actions {

using namespace usar::widgets;

namespace {

QKeyEvent press(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    return {QEvent::KeyPress, key, modifiers};
}

} // namespace

class tst_PlanActions : public QObject {
    Q_OBJECT
private slots:
    void runsAndEnablesByName();
    void keysOfTheDrawingAreOnlyForTheDrawing();
    void theDrawingHasKeysOfItsOwn_data();
    void theDrawingHasKeysOfItsOwn();
};

void tst_PlanActions::runsAndEnablesByName() {
    QWidget owner;
    PlanActions actions(owner);
    int runs = 0;
    QAction* const made =
        actions.add({"redo", "Redo", "Makes it again", "redo", QKeySequence("Ctrl+Y")}, [&] { ++runs; });
    actions.add({"undo", "Undo", "Takes it back"}, [] {});
    QCOMPARE(actions.action("redo"), made);
    QVERIFY(made->toolTip().startsWith("Makes it again ("));
    QCOMPARE(actions.action("undo")->toolTip(), QString("Takes it back"));
    made->trigger();
    actions.enable("redo", false);
    made->trigger();
    QCOMPARE(runs, 1);
    actions.enable({"redo", "undo"}, true);
    QVERIFY(made->isEnabled());
    QMenu menu;
    actions.fill(menu, {"undo", "redo"});
    QCOMPARE(menu.actions(), (QList<QAction*>{actions.action("undo"), made}));
}

void tst_PlanActions::keysOfTheDrawingAreOnlyForTheDrawing() {
    QWidget owner;
    PlanActions actions(owner);
    QAction* const limit = actions.add({"limit", "Limit", "", "", Qt::Key_L, true}, [] {});
    QAction* const next = actions.add({"next", "Next", "", "", Qt::Key_F8}, [] {});
    QCOMPARE(actions.actionOf(press(Qt::Key_L), true), limit);
    QCOMPARE(actions.actionOf(press(Qt::Key_L), false), nullptr);
    QCOMPARE(actions.actionOf(press(Qt::Key_F8), true), next);
    QCOMPARE(actions.actionOf(press(Qt::Key_F8, Qt::KeypadModifier), false), next);
    QCOMPARE(actions.actionOf(press(Qt::Key_F8, Qt::ShiftModifier), false), nullptr);
}

void tst_PlanActions::theDrawingHasKeysOfItsOwn_data() {
    QTest::addColumn<int>("key");
    QTest::addColumn<bool>("with_control");
    QTest::addColumn<bool>("own");
    QTest::newRow("folds") << int(Qt::Key_Space) << false << true;
    QTest::newRow("not with Ctrl") << int(Qt::Key_Space) << true << false;
    QTest::newRow("pans with Ctrl") << int(Qt::Key_Left) << true << true;
    QTest::newRow("a letter of nobody") << int(Qt::Key_Q) << false << false;
}

void tst_PlanActions::theDrawingHasKeysOfItsOwn() {
    QFETCH(int, key);
    QFETCH(bool, with_control);
    QFETCH(bool, own);
    QCOMPARE(isKeyOfDrawing(press(key, with_control ? Qt::ControlModifier : Qt::NoModifier)), own);
}

USAR_TEST(tst_PlanActions)

} // namespace tst_plan_actions

#include "tst_plan_actions.moc"
