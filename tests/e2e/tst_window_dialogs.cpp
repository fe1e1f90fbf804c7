// While a dialog is open, robots go on and can be stopped: no dialog of the window is modal.
#include <algorithm>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <QTest>
#include <QTimer>

#include "core/server/embedded/program_files.h"
#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/scratch_files.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"
#include "widgets/commands/command_palette.h"

namespace tst_window_dialogs {

using namespace usar;

namespace {

/// Spawned, started, and an act of its plan selected.
bool takeOff(WindowPage& page) {
    if (!QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms) || !page.spawnAt("PlayerStart"))
        return false;
    page.pressKey(Qt::Key_F4, Qt::ControlModifier);
    page.press("Start");
    widgets::PlanView& view = page.window().views().plan->view();
    if (!QTest::qWaitFor([&] { return !view.tree().empty(); }, soon_ms))
        return false;
    for (const widgets::PlanNodeId node : view.tree().nodes())
        if (view.tree()[node].kind == widgets::PlanNodeKind::Act) {
            view.select(node);
            return true;
        }
    return false;
}

/// The only open dialog of the window.
QDialog* openDialog() {
    QList<QDialog*> open;
    for (QWidget* const widget : QApplication::topLevelWidgets())
        if (auto* const dialog = qobject_cast<QDialog*>(widget); dialog && dialog->isVisible())
            open << dialog;
    return open.size() == 1 ? open.front() : nullptr;
}

/// As the window system does it: to the window, which a modal dialog would block.
void clickStopAll(WindowPage& page) {
    const QPushButton* const button = page.window().views().stop_all;
    QTest::mouseClick(page.window().windowHandle(), Qt::LeftButton, {},
                      button->mapTo(&page.window(), button->rect().center()));
}

QMenu* recentMenu(WindowPage& page) {
    const auto menus = page.window().menuBar()->findChildren<QMenu*>();
    const auto found =
        std::ranges::find_if(menus, [](const QMenu* menu) { return menu->title().remove('&') == "Open recent"; });
    return found == menus.end() ? nullptr : *found;
}

/// What the menu offers when it opens, without mnemonics.
QStringList recentFiles(WindowPage& page) {
    QMenu* const menu = recentMenu(page);
    if (!menu)
        return {};
    emit menu->aboutToShow();
    QStringList texts;
    for (const QAction* action : menu->actions())
        texts << action->text().replace("&&", "&");
    return texts;
}

/// What the palette offers of the group of files for what is typed, in its order.
QStringList fileOffers(WindowPage& page, const QString& typed) {
    QStringList texts;
    for (const widgets::PaletteOffer& offer : page.window().commands().offers())
        if (offer.group == "File" && widgets::matchScore(typed, offer.text, offer.words))
            texts << offer.text;
    return texts;
}

} // namespace

class tst_WindowDialogs : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void stopAllWorksOverADialog_data();
    void stopAllWorksOverADialog();
    void missionsAreLookedForWhereTheyAreShipped();
    void filesThatWereUsedAreOfferedAgain();
    void thePaletteOpensFilesThatWereUsed();

private:
    QTimer modal_closer_; ///< closes a modal dialog, which would stop the test for good
};

void tst_WindowDialogs::initTestCase() {
    connect(&modal_closer_, &QTimer::timeout, this, [] {
        if (QWidget* const modal = QApplication::activeModalWidget())
            modal->close();
    });
    modal_closer_.start(200);
}

void tst_WindowDialogs::stopAllWorksOverADialog_data() {
    QTest::addColumn<QString>("command");
    for (const char* command : {"file.open", "file.save", "file.open_recording", "file.folder", "plan.open",
                                "simulator.save_snapshot", "simulator.open_robot", "camera.port", "plan.break_edit"})
        QTest::newRow(command) << QString(command);
}

void tst_WindowDialogs::stopAllWorksOverADialog() {
    QFETCH(QString, command);
    const QTemporaryDir folder;
    WindowPage page({.mission_file = plannedMission(folder)});
    QVERIFY(takeOff(page));
    QAction* const action = page.window().commands().action(command);
    QTRY_VERIFY_WITH_TIMEOUT(action->isEnabled(), soon_ms);
    QTimer::singleShot(0, action, &QAction::trigger);
    QTRY_VERIFY_WITH_TIMEOUT(openDialog(), soon_ms);
    QVERIFY(!QApplication::activeModalWidget());
    QVERIFY(!page.robot(1)->finished);
    clickStopAll(page);
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->finished.has_value(), soon_ms);
    QVERIFY(openDialog());
    openDialog()->close();
}

void tst_WindowDialogs::missionsAreLookedForWhereTheyAreShipped() {
    WindowPage page;
    QVERIFY(QDir(server::missionsFolder()).exists("tall_test.json"));
    QTimer::singleShot(0, page.window().commands().action("file.open"), &QAction::trigger);
    QTRY_VERIFY_WITH_TIMEOUT(qobject_cast<QFileDialog*>(openDialog()), soon_ms);
    auto* const dialog = qobject_cast<QFileDialog*>(openDialog());
    QCOMPARE(dialog->directory(), QDir(server::missionsFolder()));
    dialog->close();
}

void tst_WindowDialogs::filesThatWereUsedAreOfferedAgain() {
    const QTemporaryDir settings;
    const QTemporaryDir folder;
    const WindowSetup setup{.settings_folder = settings.path()};
    const QString gone = fileIn(folder, "gone.lap", "((DC lookout (drives ((stay Hover)))))");
    const QString in_folder = " in " + QDir(folder.path()).dirName();
    {
        WindowPage page(setup);
        QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
        QCOMPARE(recentFiles(page), QStringList{"No files yet"});
        QVERIFY(page.dropFile(gone));
        QVERIFY(page.dropFile(plannedMission(folder)));
        QCOMPARE(recentFiles(page), QStringList({"planned.json" + in_folder, "gone.lap" + in_folder}));
        page.window().close();
        QTRY_VERIFY_WITH_TIMEOUT(!page.window().isVisible(), soon_ms);
    }
    QVERIFY(QFile::remove(gone));
    WindowPage page(setup);
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QCOMPARE(recentFiles(page), QStringList{"planned.json" + in_folder});
    recentMenu(page)->actions().front()->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(page.notified("is ready").contains("Planned"), soon_ms);
}

/// Shipped missions are offered in any case, and not twice.
void tst_WindowDialogs::thePaletteOpensFilesThatWereUsed() {
    const QTemporaryDir folder;
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QCOMPARE(fileOffers(page, "recent"), QStringList());
    QVERIFY(page.dropFile(fileIn(folder, "lookout.lap", "((DC lookout (drives ((stay Hover)))))")));
    QVERIFY(page.dropFile(plannedMission(folder)));
    QVERIFY(page.dropFile(server::missionsFolder() + "/quick_scan.json"));
    QVERIFY(recentFiles(page).value(0).startsWith("quick_scan.json"));
    QCOMPARE(fileOffers(page, "recent"), QStringList({"Open planned.json", "Open lookout.lap"}));
    QCOMPARE(fileOffers(page, "open quick"), QStringList{"Open mission quick scan"});

    widgets::CommandListModel palette(page.window().commands());
    palette.setFilter("open planned");
    palette.run(palette.index(0));
    QVERIFY(recentFiles(page).value(0).startsWith("planned.json"));
}

USAR_TEST(tst_WindowDialogs)

} // namespace tst_window_dialogs

#include "tst_window_dialogs.moc"
