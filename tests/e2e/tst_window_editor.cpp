// A plan is written, checked, saved and put into a flying robot, in the real window against the real simulator.
#include <algorithm>

#include <QApplication>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>

#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/scratch_files.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"

namespace tst_window_editor {

using namespace usar;

namespace {

const char* const lookout = "((DC lookout (drives ((stay Hover)))))";

QByteArray textOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Empty: the plan that comes with the robot.
QByteArray planKey(const QString& plan) {
    return plan.isEmpty() ? QByteArray() : ", \"plan\": \"" + plan.toUtf8() + '"';
}

/// A window whose robot is set up to be decided by this plan.
class PlannedPage : public WindowPage {
public:
    explicit PlannedPage(const QTemporaryDir& folder, const QString& plan)
        : WindowPage({.mission_file = fileIn(folder, "planned.json",
                                             R"({ "name": "Planned", "behavior": "airrobot/posh",
            "area": { "x": -10, "y": -10, "width": 20, "height": 20 })" +
                                                 planKey(plan) + " }")}) {}

    widgets::PlanEditor* editor() {
        pressKey(Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
        return window().workshop().editor();
    }
};

void replace(widgets::PlanEditor& editor, const QString& old_words, const QString& words) {
    QVERIFY2(editor.textEdit().find(old_words, QTextDocument::FindBackward) || editor.textEdit().find(old_words),
             qPrintable(old_words));
    QTest::keyClicks(&editor.textEdit(), words);
    editor.catchUp();
}

/// Presses that button of the question that the editor asks.
void answer(widgets::PlanEditor& editor, const QString& text) {
    auto* const box = editor.findChild<QMessageBox*>();
    QVERIFY(box);
    QVERIFY(!QApplication::activeModalWidget());
    for (QAbstractButton* button : box->buttons())
        if (button->text().remove('&') == text)
            return QTest::mouseClick(button, Qt::LeftButton);
    QFAIL(qPrintable("no answer says " + text));
}

} // namespace

class tst_WindowEditor : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void theRobotsOwnPlanIsReadAndSavedElsewhere();
    void aChangedPlanIsPutIntoTheFlyingRobot();
    void aPlanThatDoesNotFitIsShownToBeMended();
    void aChangedPlanIsAskedForAtClosing();
    void aPlanWithoutAFileIsSavedAndThenTheWindowCloses();
    void thePlanStaysWithTheRobotItWasOpenedFor();
};

void tst_WindowEditor::theRobotsOwnPlanIsReadAndSavedElsewhere() {
    const QTemporaryDir folder;
    PlannedPage page(folder, "");
    QVERIFY(QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms));
    widgets::PlanEditor* const editor = page.editor();
    QVERIFY(editor && editor->isVisible());
    QCOMPARE(editor->name(), QString("airrobot.lap"));
    QVERIFY(!posh::hasErrors(editor->findings()));
    QVERIFY(QString::fromStdString(editor->text()).contains("RobotLaunch"));
    replace(*editor, "Scans an area in lanes", "Maps an area in lanes");
    QVERIFY(editor->isModified());
    const QString path = folder.filePath("mine.lap");
    QVERIFY(editor->save(path));
    QTRY_COMPARE(page.window().views().behavior->plan().path(), path); // what was saved decides
    QVERIFY(textOf(path).contains("Maps an area in lanes"));
}

void tst_WindowEditor::aChangedPlanIsPutIntoTheFlyingRobot() {
    const QTemporaryDir folder;
    PlannedPage page(folder, fileIn(folder, "lookout.lap", lookout));
    QVERIFY(QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms));
    QVERIFY(page.spawnAt("PlayerStart"));
    widgets::PlanEditor* const editor = page.editor();
    QVERIFY(!editor->action("apply")->isEnabled());
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(editor->action("apply")->isEnabled(), soon_ms);
    replace(*editor, "Hover", "ClimbTo(12.0)");
    editor->action("apply")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("lookout.lap").isEmpty(), soon_ms);
    QTRY_VERIFY_WITH_TIMEOUT(page.window().views().plan->textEdit().toPlainText().contains("ClimbTo(12.0)"), soon_ms);

    replace(*editor, "ClimbTo", "ClimTo");
    QVERIFY(posh::hasErrors(editor->findings()));
    QVERIFY(!editor->action("apply")->isEnabled());
    page.press("Stop");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->finished, soon_ms);
    editor->action("undo")->trigger(); // so that nothing is asked at the end
    QVERIFY(editor->save(folder.filePath("lookout.lap")).has_value());
}

void tst_WindowEditor::aPlanThatDoesNotFitIsShownToBeMended() {
    const QTemporaryDir folder;
    PlannedPage page(folder, "");
    QVERIFY(QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms));
    QVERIFY(page.dropFile(fileIn(folder, "broken.lap", "((DC lookout (drives ((stay Hoover)))))")));
    widgets::PlanEditor* const editor = page.window().workshop().editor();
    QVERIFY(editor && editor->isVisible());
    QVERIFY(posh::hasErrors(editor->findings()));
    QVERIFY(page.window().views().behavior->plan().path().isEmpty());
    replace(*editor, "Hoover", "Hover");
    QVERIFY(!posh::hasErrors(editor->findings()));
    editor->action("save")->trigger();
    QTRY_COMPARE(page.window().views().behavior->plan().path(), folder.filePath("broken.lap"));
    QVERIFY(textOf(folder.filePath("broken.lap")).contains("Hover"));
}

void tst_WindowEditor::aChangedPlanIsAskedForAtClosing() {
    const QTemporaryDir folder;
    const QString path = fileIn(folder, "lookout.lap", lookout);
    PlannedPage page(folder, path);
    QVERIFY(QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms));
    widgets::PlanEditor* const editor = page.editor();
    replace(*editor, "stay", "remain");
    page.window().close();
    answer(*editor, "Cancel");
    QVERIFY(page.window().isVisible());
    QVERIFY(editor->isModified());
    page.window().close();
    page.window().close(); // an impatient person: the question stands open already
    const auto boxes = editor->findChildren<QMessageBox*>();
    QCOMPARE(std::ranges::count_if(boxes, [](const QMessageBox* box) { return box->isVisible(); }), 1);
    answer(*editor, "Discard");
    QTRY_VERIFY_WITH_TIMEOUT(!page.window().isVisible(), soon_ms);
    QCOMPARE(textOf(path), QByteArray(lookout));
}

void tst_WindowEditor::aPlanWithoutAFileIsSavedAndThenTheWindowCloses() {
    const QTemporaryDir folder;
    PlannedPage page(folder, "");
    QVERIFY(QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms));
    widgets::PlanEditor* const editor = page.editor();
    replace(*editor, "Scans an area in lanes", "Maps an area in lanes");
    page.window().close();
    answer(*editor, "Save");
    QTRY_VERIFY(editor->findChild<QFileDialog*>());
    auto* const dialog = editor->findChild<QFileDialog*>();
    QVERIFY(page.window().isVisible());
    dialog->findChild<QLineEdit*>("fileNameEdit")->setText(folder.filePath("mine"));
    for (QAbstractButton* button : dialog->findChildren<QAbstractButton*>())
        if (button->text().remove('&') == "Save")
            QTest::mouseClick(button, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!page.window().isVisible(), soon_ms);
    QVERIFY(textOf(folder.filePath("mine.lap")).contains("Maps an area in lanes"));
}

void tst_WindowEditor::thePlanStaysWithTheRobotItWasOpenedFor() {
    const QTemporaryDir folder;
    PlannedPage page(folder, "");
    QVERIFY(QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms));
    QVERIFY(page.spawnAt("PlayerStart"));
    widgets::PlanEditor* const editor = page.editor();
    QVERIFY(!posh::hasErrors(editor->findings()));
    mission::SpawnRequest other;
    other.class_name = "USARBot.P2DX";
    other.robot_name = "R2";
    other.start_in_map.position_m = page.map().content().start_poses.back().pose_in_map.position_m;
    const auto spawned = [&] { return page.window().control().spawn(other).has_value(); };
    QVERIFY(QTest::qWaitFor(spawned, soon_ms));
    QTRY_VERIFY(QString::fromStdString(page.window().views().behavior->behaviorId()).startsWith("p2dx/"));
    QCOMPARE(editor->name(), QString("airrobot.lap"));
    QVERIFY2(!posh::hasErrors(editor->findings()), "these would be errors of an AirRobot's plan in a P2DX");
}

USAR_TEST(tst_WindowEditor)

} // namespace tst_window_editor

#include "tst_window_editor.moc"
