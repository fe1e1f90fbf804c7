// A newcomer's first flight, and what can go wrong with it, in the real window against the real simulator over TCP.
#include <QDir>
#include <QDirIterator>
#include <QProcess>
#include <QTest>

#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/scratch_files.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"

namespace tst_window {

using namespace usar;

namespace {

/// Runs a reader that is not ours; its output on failure.
QString complaintOf(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.start(program, arguments);
    if (!process.waitForStarted())
        return program + " is not installed (tests/run installs it)";
    process.waitForFinished();
    return process.exitCode() == 0 ? QString() : QString::fromLocal8Bit(process.readAll());
}

} // namespace

class tst_Window : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void firstFlightFromDoubleClickToFiles();
    void closingInTheMiddleKeepsTheScan();
    void escapeTwiceStopsEveryRobot();
    void anEscapeThatLeavesAToolIsNoHalfOfTheStop();
    void anUnwritableFolderIsNamedAndNothingIsLost();
};

void tst_Window::firstFlightFromDoubleClickToFiles() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY2(page.connectionText().contains("tall_test"), qPrintable(page.connectionText()));
    page.doubleClickStartPose("PlayerStart");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.robot(1)->figures.spawned, soon_ms);
    page.pressKey(Qt::Key_A);
    page.drawArea({{-15, -10}, {15, 10}});
    QVERIFY(page.map().area().has_value());
    QVERIFY(!page.map().content().area.lanes_in_map_m.empty());
    QVERIFY(!page.map().content().area.summary.isEmpty());

    page.chooseSpeed("max");
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(page.knownTiles() >= 2, flight_ms);
    const std::size_t tiles_before = page.knownTiles();
    page.screenshot("scan_begins");
    const Vec2 center_before = page.map().transform().center_m;
    page.pressKey(Qt::Key_Right);
    page.pressKey(Qt::Key_Up);
    QVERIFY(page.map().transform().center_m != center_before);
    QTRY_VERIFY_WITH_TIMEOUT(page.knownTiles() > tiles_before || page.robot(1)->finished, flight_ms);

    page.pressKey(Qt::Key_E, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(!filesIn(page.resultFolder(), ".json").isEmpty(), soon_ms);
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->finished.has_value(), flight_ms);
    QVERIFY2(page.robot(1)->finished->success, page.robot(1)->finished->reason.c_str());
    QTRY_VERIFY_WITH_TIMEOUT(filesIn(page.resultFolder(), ".json").size() >= 2, soon_ms);
    page.screenshot("scan_done");

    const QDir folder(page.resultFolder());
    for (const QString& raw : filesIn(folder.path(), ".bil"))
        QCOMPARE(complaintOf("gdalinfo", {folder.filePath(raw)}), QString());
    const QStringList pictures = filesIn(folder.path(), ".png");
    QVERIFY(pictures.size() >= 4);
    for (const QString& picture : pictures)
        QCOMPARE(complaintOf("pngcheck", {"-q", folder.filePath(picture)}), QString());
}

void tst_Window::closingInTheMiddleKeepsTheScan() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.doubleClickStartPose("PlayerStart");
    page.pressKey(Qt::Key_A);
    page.drawArea({{-20, -15}, {20, 15}});
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.robot(1)->figures.spawned, soon_ms);
    page.chooseSpeed("max");
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(page.knownTiles() >= 1, flight_ms);
    page.window().quit();
    QTRY_VERIFY_WITH_TIMEOUT(!page.window().isVisible(), soon_ms);
    QCOMPARE(filesIn(page.resultFolder(), ".bil").size(), 1);
}

void tst_Window::escapeTwiceStopsEveryRobot() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.doubleClickStartPose("PlayerStart");
    page.pressKey(Qt::Key_A);
    page.drawArea({{-20, -15}, {20, 15}});
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.robot(1)->figures.spawned, soon_ms);
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.behavior_running, soon_ms);
    page.pressKey(Qt::Key_Escape);
    page.pressKey(Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(!page.robot(1)->figures.behavior_running, soon_ms);
}

/// Defect D12 of the review: whoever left the area tool by Escape and pressed it again stopped all robots.
void tst_Window::anEscapeThatLeavesAToolIsNoHalfOfTheStop() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    page.typeArea({{-20, -15}, {20, 15}});
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.behavior_running, soon_ms);
    page.pressKey(Qt::Key_A);
    QVERIFY(page.window().commands().action("mission.area")->isChecked());
    QVERIFY(page.map().hasFocus());
    page.pressKey(Qt::Key_Escape);
    QVERIFY(!page.window().commands().action("mission.area")->isChecked());
    page.pressKey(Qt::Key_Escape);
    QVERIFY(page.holdsWhileClockGoesOn([&] { return page.robot(1)->figures.behavior_running; }, Seconds(1.0)));
}

void tst_Window::anUnwritableFolderIsNamedAndNothingIsLost() {
    QTemporaryDir elsewhere;
    QFile blocker(elsewhere.filePath("taken"));
    QVERIFY(blocker.open(QIODevice::WriteOnly)); // a file where the folder should be: not even root can write there
    WindowPage page({.result_folder = elsewhere.filePath("taken")});
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.doubleClickStartPose("PlayerStart");
    page.pressKey(Qt::Key_A);
    page.drawArea({{-20, -15}, {20, 15}});
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.robot(1)->figures.spawned, soon_ms);
    page.chooseSpeed("max");
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(page.knownTiles() >= 1, flight_ms);
    QString said;
    QObject::connect(&page.window().control(), &app::MissionControl::exportFailed,
                     [&said](RobotId, const QString& reason) { said = reason; });
    page.pressKey(Qt::Key_E, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(said.contains("taken"), soon_ms);
    QVERIFY(page.robot(1)->unsaved);
}

USAR_TEST(tst_Window)

} // namespace tst_window

#include "tst_window.moc"
