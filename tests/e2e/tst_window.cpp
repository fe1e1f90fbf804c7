// A newcomer's first flight, and what can go wrong with it, in the real window against the real simulator over TCP.
#include <QDir>
#include <QDirIterator>
#include <QProcess>
#include <QTest>

#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/window_page.h"

using namespace usar;

namespace {

constexpr int soon_ms = 15000;    // sockets and threads on a busy machine
constexpr int flight_ms = 120000; // a robot that flies at full speed

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr qint64 longest_block_ms = 500; // everything is several times slower there
#else
constexpr qint64 longest_block_ms = 100;
#endif

QStringList filesIn(const QString& folder, const QString& ending) {
    return QDir(folder).entryList({"*" + ending}, QDir::Files);
}

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
    void firstFlightFromDoubleClickToFiles();
    void closingInTheMiddleKeepsTheScan();
    void escapeTwiceStopsEveryRobot();
    void anUnwritableFolderIsNamedAndNothingIsLost();
    void aDeadServerIsNamedAndTheWindowLives();
};

void tst_Window::firstFlightFromDoubleClickToFiles() {
    WindowPage page;
    auto* watchdog = static_cast<GuiWatchdog*>(qApp);
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY2(page.connectionText().contains("tall_test"), qPrintable(page.connectionText()));
    watchdog->reset();
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
    page.map().setFocus();
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
    QVERIFY2(watchdog->longestBlock_ms() <= longest_block_ms,
             qPrintable(QString("%1 ms in %2").arg(watchdog->longestBlock_ms()).arg(watchdog->longestWhere())));

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
    page.window().close();
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

void tst_Window::anUnwritableFolderIsNamedAndNothingIsLost() {
    QTemporaryDir elsewhere;
    QFile blocker(elsewhere.filePath("taken"));
    QVERIFY(blocker.open(QIODevice::WriteOnly)); // a file where the folder should be: not even root can write there
    WindowPage page(elsewhere.filePath("taken"));
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
                     [&said](int, const QString& reason) { said = reason; });
    page.pressKey(Qt::Key_E, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(said.contains("taken"), soon_ms);
    QVERIFY(page.robot(1)->unsaved);
}

void tst_Window::aDeadServerIsNamedAndTheWindowLives() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QTcpServer nobody;
    QVERIFY(nobody.listen(QHostAddress::LocalHost));
    const quint16 dead_port = nobody.serverPort();
    nobody.close();
    page.window().views().connection->setAddress("127.0.0.1", dead_port);
    emit page.window().views().connection->connectRequested(widgets::ServerChoice::Real, "127.0.0.1", dead_port);
    QTRY_VERIFY_WITH_TIMEOUT(page.connectionText().contains(QString::number(dead_port)), soon_ms);
    QVERIFY(page.window().isVisible());
}

int main(int argc, char** argv) {
    GuiWatchdog application(argc, argv);
    QApplication::setApplicationName("Mission Control");
    QApplication::setOrganizationName("USAR");
    tst_Window test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_window.moc"
