// Bad input in the real window: each gets one clear message with the mend, the window lives, and no scan is lost.
#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QTcpServer>
#include <QTest>

#include "core/server/embedded/headless_simulator.h"
#include "core/server/embedded/program_files.h"
#include "tests/doubles/fake_server.h"
#include "tests/doubles/meddling_relay.h"
#include "tests/doubles/test_files.h"
#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/scratch_files.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"
#include "widgets/panels/plugin_dialog.h"

namespace tst_window_trouble {

using namespace usar;

namespace {

constexpr double server_speed_x = 5.0;

/// A real simulator behind a relay that a test can meddle with; the window takes it for somebody's server.
struct TroubledServer {
    std::unique_ptr<server::HeadlessSimulator> simulator;
    std::unique_ptr<test::MeddlingRelay> relay;

    TroubledServer() {
        auto started = server::HeadlessSimulator::start("tall_test", {.speed_x = server_speed_x});
        if (!started)
            qFatal("%s", started.error().text().c_str());
        simulator = *std::move(started);
        relay = std::make_unique<test::MeddlingRelay>(simulator->port());
    }
};

bool connectedTo(WindowPage& page, const TroubledServer& server) {
    page.connectToServer("127.0.0.1", server.relay->port());
    return QTest::qWaitFor([&] { return page.hasStartPoses(); }, soon_ms);
}

} // namespace

class tst_WindowTrouble : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void aServerThatIsNotThereIsNamed_data();
    void aServerThatIsNotThereIsNamed();
    void aPortThatSpeaksSomethingElseIsNamed();
    void aServerThatClosesInTheMiddleCostsNoScan();
    void silenceAfterInitIsSaidAndTheRobotCanBeSpawnedAgain();
    void badLinesAreNamedAndTheRobotLives_data();
    void badLinesAreNamedAndTheRobotLives();
    void aSensorThatStopsIsNamed();
    void whatAStockRobotLacksIsNamedWithItsFile();
    void theTroubleOfARobotGoesWithIt();
    void aNotificationLeadsToItsRobotAndDock();
    void anAreaThatCannotBeFlownIsRefused_data();
    void anAreaThatCannotBeFlownIsRefused();
    void anAreaThatIsPartlyOutsideIsFlownWithAWarning();
    void aWrongMissionFileIsRefusedWithItsPlace_data();
    void aWrongMissionFileIsRefusedWithItsPlace();
    void aMissingPluginIsNamed();
    void aBrokenPluginIsNamed();
    void aPortInUseIsToldAndAnotherTaken();
    void anUnwritableFolderAtClosingAsksForAnother();
};

void tst_WindowTrouble::aServerThatIsNotThereIsNamed_data() {
    QTest::addColumn<QString>("host");
    QTest::addColumn<bool>("port_matters");
    QTest::newRow("nobody listens") << "127.0.0.1" << true;
    QTest::newRow("no such host") << "no-such-host.invalid" << false;
}

void tst_WindowTrouble::aServerThatIsNotThereIsNamed() {
    QFETCH(QString, host);
    QFETCH(bool, port_matters);
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QTcpServer nobody;
    QVERIFY(nobody.listen(QHostAddress::LocalHost));
    const quint16 dead_port = nobody.serverPort();
    nobody.close();
    page.connectToServer(host, dead_port);
    const QString place = port_matters ? host + ":" + QString::number(dead_port) : host;
    QTRY_VERIFY2_WITH_TIMEOUT(page.connectionText().contains(place), qPrintable(page.connectionText()), soon_ms);
    QTRY_COMPARE_WITH_TIMEOUT(page.connectionText().count("Retrying"), 1, soon_ms);
    QVERIFY2(!page.notified(place).isEmpty(), qPrintable(place));
    QVERIFY(page.window().isVisible());
}

void tst_WindowTrouble::aPortThatSpeaksSomethingElseIsNamed() {
    test::FakeServer other;
    QVERIFY(other.listen());
    other.on_connect = [&] { other.say("SSH-2.0-OpenSSH_9.2p1 Debian-2\r\n"); };
    WindowPage page;
    page.connectToServer("127.0.0.1", other.port());
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("USARSim").isEmpty(), soon_ms);
    QVERIFY2(page.notified("USARSim").contains(QString::number(other.port())), qPrintable(page.notified("USARSim")));
}

void tst_WindowTrouble::aServerThatClosesInTheMiddleCostsNoScan() {
    TroubledServer server;
    WindowPage page;
    QVERIFY(connectedTo(page, server));
    QVERIFY(page.spawnAt("PlayerStart"));
    page.pressKey(Qt::Key_A);
    page.drawArea({{-20, -15}, {20, 15}});
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(page.knownTiles() >= 1, flight_ms);
    server.relay->die();
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("What was scanned is kept").isEmpty(), soon_ms);
    QTRY_COMPARE_WITH_TIMEOUT(filesIn(page.resultFolder(), ".bil").size(), 1, soon_ms);
    QVERIFY(page.knownTiles() >= 1);
    server.relay->revive();
    QTRY_VERIFY_WITH_TIMEOUT(page.window().commands().action("robot.spawn_again")->isEnabled(), soon_ms);
    page.pressKey(Qt::Key_R, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.spawned, soon_ms);
    QVERIFY(page.window().commands().action("mission.start")->isEnabled());
}

void tst_WindowTrouble::silenceAfterInitIsSaidAndTheRobotCanBeSpawnedAgain() {
    TroubledServer server;
    WindowPage page;
    QVERIFY(connectedTo(page, server));
    server.relay->meddle = [](const QByteArray& line) { return line.startsWith("NFO") ? line : QByteArray(); };
    page.doubleClickStartPose("PlayerStart");
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("after INIT").isEmpty(), soon_ms);
    QVERIFY2(page.notified("after INIT").contains("R1"), qPrintable(page.notified("after INIT")));
    QVERIFY(!page.window().commands().action("mission.start")->isEnabled());
    server.relay->meddle = {};
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.spawned, soon_ms); // it was only slow to speak
    QVERIFY(page.window().commands().action("mission.start")->isEnabled());
}

void tst_WindowTrouble::badLinesAreNamedAndTheRobotLives_data() {
    QTest::addColumn<QByteArray>("said");
    QTest::addColumn<QString>("words");
    QTest::newRow("garbled") << QByteArray("SEN {Type INS} {Name INS} {Location 1.0,2.0\r\n") << "SEN";
    QTest::newRow("endless") << QByteArray(5 << 20, 'x') + "\r\n"
                             << "4 MiB";
    QTest::newRow("no number") << QByteArray("SEN {Type RangeScanner} {Name Scanner1} {Resolution 0.1} {FOV 0.2} "
                                             "{Range 2.0,nan,2.0}\r\n")
                               << "RangeScanner";
}

void tst_WindowTrouble::badLinesAreNamedAndTheRobotLives() {
    QFETCH(QByteArray, said);
    QFETCH(QString, words);
    TroubledServer server;
    WindowPage page;
    QVERIFY(connectedTo(page, server));
    QVERIFY(page.spawnAt("PlayerStart"));
    server.relay->say(said);
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified(words).isEmpty(), soon_ms);
    const Seconds then = page.robot(1)->figures.now;
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.now > then + Seconds(1.0), soon_ms);
    QVERIFY(page.robot(1)->figures.spawned);
}

void tst_WindowTrouble::aSensorThatStopsIsNamed() {
    TroubledServer server;
    WindowPage page;
    QVERIFY(connectedTo(page, server));
    QVERIFY(page.spawnAt("PlayerStart"));
    const Seconds then = page.robot(1)->figures.now;
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.now > then + Seconds(1.0), soon_ms); // all sensors have spoken
    server.relay->meddle = [](const QByteArray& line) { return line.contains("RangeScanner") ? QByteArray() : line; };
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("No reading from").isEmpty(), soon_ms);
    QVERIFY2(page.notified("No reading from").contains("Scanner"), qPrintable(page.notified("No reading from")));
    server.relay->meddle = {};
    QTRY_VERIFY_WITH_TIMEOUT(page.window().views().notifications->model()->openCount() == 0, soon_ms);
}

/// As on a server whose AirRobot has neither scanner nor INS.
void tst_WindowTrouble::whatAStockRobotLacksIsNamedWithItsFile() {
    TroubledServer server;
    WindowPage page;
    server.relay->meddle = [](const QByteArray& line) {
        for (const QByteArray type : {"RangeScanner", "INS"})
            if (line.contains("{Type " + type + "}"))
                return line.startsWith("SEN") ? QByteArray()
                                              : line.left(line.indexOf(' ')) + " {Type " + type + "}\r\n";
        return line;
    };
    QVERIFY(connectedTo(page, server));
    QVERIFY(page.spawnAt("PlayerStart"));
    page.typeArea({{-20, -15}, {20, 15}});
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("needs the sensors").isEmpty(), flight_ms);
    QVERIFY2(page.notified("needs the sensors").contains("INS"), qPrintable(page.notified("needs the sensors")));
    QVERIFY(page.notified("needs the sensors").contains("RangeScanner"));
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("USARBot.ini").isEmpty(), soon_ms);
    const QString advice = page.notified("USARBot.ini");
    QVERIFY2(advice.contains(server::serverFilesFolder()), qPrintable(advice));
    QVERIFY(QFile::exists(server::serverFilesFolder() + "/USARBot.ini"));
    QVERIFY(QFile::exists(server::serverFilesFolder() + "/DefaultUSAR.ini"));
    page.screenshot("missing_sensors");
}

/// Defect D19 of the review: dozens of problems stood open, most of them of robots that were gone.
void tst_WindowTrouble::theTroubleOfARobotGoesWithIt() {
    TroubledServer server;
    WindowPage page;
    QVERIFY(connectedTo(page, server));
    QVERIFY(page.spawnAt("PlayerStart"));
    QVERIFY(page.clockGoesOn(Seconds(1.0))); // All sensors have spoken.
    server.relay->meddle = [](const QByteArray& line) { return line.contains("RangeScanner") ? QByteArray() : line; };
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("No reading from").isEmpty(), soon_ms);
    const auto* const model = page.window().views().notifications->model();
    const auto open = [&] {
        int rows = 0;
        for (int row = 0; row < model->rowCount(); ++row)
            rows += model->row(row).severity != Severity::Note && !model->row(row).cured ? 1 : 0;
        return rows;
    };
    QVERIFY(open() >= 1);
    page.window().control().remove({1});
    QTRY_COMPARE(open(), 0);
    QVERIFY(!page.notified("No reading from").isEmpty()); // It is still in the list.
}

void tst_WindowTrouble::aNotificationLeadsToItsRobotAndDock() {
    TroubledServer server;
    WindowPage page;
    QVERIFY(connectedTo(page, server));
    QVERIFY(page.spawnAt("PlayerStart"));
    QVERIFY(page.clockGoesOn(Seconds(1.0))); // All sensors have spoken.
    server.relay->meddle = [](const QByteArray& line) { return line.contains("RangeScanner") ? QByteArray() : line; };
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified("No reading from").isEmpty(), soon_ms);
    QVERIFY(page.spawnAt(page.map().content().start_poses.back().name));
    QCOMPARE(page.window().selectedRobot(), RobotId{2});
    page.window().commands().action("view.dock.sensors")->trigger(); // Closes it.
    QTRY_VERIFY(!page.window().views().sensors->isVisible());
    page.window().commands().action("view.dock.notifications")->trigger();
    auto* const list = page.window().views().notifications->findChild<QListView*>();
    QTRY_VERIFY(list->isVisible());
    const auto* const model = page.window().views().notifications->model();
    int row = 0;
    while (row < model->rowCount() && !model->row(row).text.contains("No reading from"))
        ++row;
    QVERIFY(row < model->rowCount());
    list->setCurrentIndex(list->model()->index(row, 0));
    emit list->activated(list->currentIndex()); // A double-click, or Return.
    QCOMPARE(page.window().selectedRobot(), RobotId{1});
    QTRY_VERIFY(page.window().views().sensors->isVisible());
}

void tst_WindowTrouble::anAreaThatCannotBeFlownIsRefused_data() {
    QTest::addColumn<Rectangle>("area");
    QTest::addColumn<QString>("words");
    QTest::newRow("no size") << Rectangle{{5, 5}, {5, 9}} << "needs a mission area";
    QTest::newRow("outside the world") << Rectangle{{180, 80}, {200, 90}} << "entirely outside the world";
}

void tst_WindowTrouble::anAreaThatCannotBeFlownIsRefused() {
    QFETCH(Rectangle, area);
    QFETCH(QString, words);
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    page.typeArea(area);
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified(words).isEmpty(), soon_ms);
    QVERIFY(!page.robot(1)->figures.behavior_running);
}

void tst_WindowTrouble::anAreaThatIsPartlyOutsideIsFlownWithAWarning() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    page.typeArea({{120, 80}, {136, 90}});
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.behavior_running, soon_ms);
    QVERIFY(!page.notified("50 % of the mission area").isEmpty());
}

void tst_WindowTrouble::aWrongMissionFileIsRefusedWithItsPlace_data() {
    QTest::addColumn<QString>("json");
    QTest::addColumn<QString>("words");
    QTest::newRow("broken") << "{\n  \"name\": \"x\",\n  \"area\" {}\n}"
                            << "mission.json:3:";
    QTest::newRow("unknown key") << "{\n  \"name\": \"x\",\n  \"aera\": {}\n}"
                                 << "mission.json:3:";
    QTest::newRow("outside the world")
        << "{\n  \"name\": \"x\",\n  \"area\": {\"x\": 500, \"y\": 0, \"width\": 900, \"height\": 20}\n}"
        << "entirely outside the world";
    QTest::newRow("unknown parameter")
        << "{\n \"name\": \"x\",\n \"area\": {\"x\": 0, \"y\": 0, \"width\": 9, \"height\": 9},\n"
           " \"parameters\": {\"scan_altitude\": 6}\n}"
        << "scan_altitude";
    QTest::newRow("an unknown world") << "{\n \"name\": \"x\",\n \"world\": \"atlantis\",\n"
                                         " \"area\": {\"x\": 0, \"y\": 0, \"width\": 9, \"height\": 9}\n}"
                                      << "mission.json:3:11: this mission belongs to the world atlantis";
}

void tst_WindowTrouble::aWrongMissionFileIsRefusedWithItsPlace() {
    QFETCH(QString, json);
    QFETCH(QString, words);
    QTemporaryDir folder;
    const QString file = folder.filePath("mission.json");
    doubles::writeAll(file.toStdString(), json.toStdString());
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.window().mission().openMission(file);
    QVERIFY2(!page.notified(words).isEmpty(), qPrintable(page.notified({})));
    QVERIFY(!page.map().area());
}

void tst_WindowTrouble::aMissingPluginIsNamed() {
    QTemporaryDir empty;
    WindowPage page({.plugin_folders = {empty.path()}});
    QVERIFY(page.notified(empty.path()).contains("No robot plugin"));
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.notified(empty.path()).contains("name another folder with --plugins"));
    page.doubleClickStartPose("PlayerStart"); // the simulator's robots can be driven by commands all the same
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.robot(1)->figures.spawned, soon_ms);
    QVERIFY(!page.window().commands().action("mission.start")->isEnabled() ||
            page.window().views().behavior->behaviorId().empty());
}

void tst_WindowTrouble::aBrokenPluginIsNamed() {
    QTemporaryDir folder;
    const QString built = QStringLiteral(USAR_BINARY_DIR "/tests/plugins/");
    QVERIFY(QFile::copy(built + "throws_when_made.so", folder.filePath("throws_when_made.so")));
    doubles::writeAll(folder.filePath("cut_off.so").toStdString(), "\x7f"
                                                                   "ELF");
    WindowPage page({.plugin_folders = {folder.path(), QStringLiteral(USAR_BINARY_DIR "/robots")}});
    QVERIFY(!page.notified("throws_when_made.so").isEmpty());
    QVERIFY(!page.notified("cut_off.so").isEmpty());
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart")); // the good one works all the same
    page.window().commands().action("plugins.show")->trigger();
    const auto* const list = page.window().findChild<widgets::PluginDialog*>();
    QVERIFY(list && list->isVisible() && !list->isModal());
    int refused = 0;
    int loaded = 0;
    for (const widgets::PluginRow& row : list->plugins()) {
        refused += row.state == "refused" && !row.reason.isEmpty() ? 1 : 0;
        loaded += row.state == "loaded" && !row.behaviors.isEmpty() && !row.version.isEmpty() ? 1 : 0;
    }
    QCOMPARE(refused, 2);
    QVERIFY(loaded >= 1);
}

void tst_WindowTrouble::aPortInUseIsToldAndAnotherTaken() {
    QTcpServer other;
    QVERIFY(other.listen(QHostAddress::LocalHost));
    WindowPage page({.simulator_port = other.serverPort()});
    const QString words = QString("Port %1 is in use").arg(other.serverPort());
    QTRY_VERIFY_WITH_TIMEOUT(!page.notified(words).isEmpty(), soon_ms);
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
}

void tst_WindowTrouble::anUnwritableFolderAtClosingAsksForAnother() {
    QTemporaryDir elsewhere;
    const QString taken = elsewhere.filePath("taken");
    doubles::writeAll(taken.toStdString(), "a file where the folder should be");
    WindowPage page({.result_folder = taken});
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    page.pressKey(Qt::Key_A);
    page.drawArea({{-20, -15}, {20, 15}});
    page.chooseSpeed("max");
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(page.knownTiles() >= 1, flight_ms);
    page.window().close();
    widgets::QuestionStrip* const question = page.window().views().question;
    if (question->openQuestion() == "quit")
        page.press("Stop and quit");
    QTRY_COMPARE_WITH_TIMEOUT(question->openQuestion(), QString("unsaved"), soon_ms);
    QVERIFY(!QApplication::activeModalWidget());
    QVERIFY2(question->accessibleName().contains("taken"), qPrintable(question->accessibleName()));
    question->give(2); // Keep the window open.
    QVERIFY(page.window().isVisible());
    QVERIFY(page.robot(1)->unsaved);
    QVERIFY(QDir(elsewhere.path()).mkdir("free"));
    page.window().close();
    QTRY_COMPARE_WITH_TIMEOUT(question->openQuestion(), QString("unsaved"), soon_ms);
    page.press("Choose another folder…");
    auto* const dialog = page.window().findChild<QFileDialog*>();
    QVERIFY(dialog && dialog->isVisible());
    dialog->findChild<QLineEdit*>("fileNameEdit")->setText(elsewhere.filePath("free"));
    for (QAbstractButton* button : dialog->findChildren<QAbstractButton*>())
        if (button->text().remove('&') == "Choose")
            QTest::mouseClick(button, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!page.window().isVisible(), soon_ms);
    QCOMPARE(filesIn(elsewhere.filePath("free"), ".bil").size(), 1);
}

USAR_TEST(tst_WindowTrouble)

} // namespace tst_window_trouble

#include "tst_window_trouble.moc"
