// What is in the world and in the air, as the map of the real window shows it: robots at their true size.
#include <QTest>
#include <QTimer>

#include "tests/doubles/fake_robot_server.h"
#include "tests/e2e/drive_page.h"
#include "tests/e2e/gui_watchdog.h"
#include "tests/suite/suite.h"

namespace tst_window_map {

using namespace usar;

namespace {

/// Of the first robot on the map; 0 while its outline is not known.
double shownLength_m(WindowPage& page) {
    const auto& robots = page.map().content().robots;
    if (robots.empty() || !robots.begin()->second.robot.footprint)
        return 0.0;
    return robots.begin()->second.robot.footprint->length_m;
}

} // namespace

class tst_WindowMap : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void embeddedRobotHasTheOutlineOfItsFile();
    void robotOfAnotherServerHasTheSizeThatItTells();
};

void tst_WindowMap::embeddedRobotHasTheOutlineOfItsFile() {
    DrivePage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnClass("AirRobot"));
    QTRY_VERIFY(shownLength_m(page) > 0.0);
    const auto footprint = page.map().content().robots.at("R1").robot.footprint;
    QVERIFY(std::abs(footprint->length_m - 0.999) < 0.02);    // Its ring.
    QVERIFY(!footprint->shape.contains(QPointF(0.49, 0.49))); // It is round.
    QVERIFY(footprint->shape.contains(QPointF(0.3, 0.3)));
}

void tst_WindowMap::robotOfAnotherServerHasTheSizeThatItTells() {
    test::FakeRobotServer server;
    QVERIFY(server.listen());
    QTimer ticks;
    connect(&ticks, &QTimer::timeout, &server, &test::FakeRobotServer::tick);
    server.on_command = [&](const QByteArray& line) {
        if (line.startsWith("INIT")) {
            server.keepClient();
            ticks.start(20);
        } else if (line.startsWith("GETGEO {Type Robot}")) {
            server.say("GEO {Type AerialVehicle} {Name USARBot.AirRobot} {Dimensions 1.7000,1.2000,0.3000} {COG "
                       "0.0000,0.0000,0.0000}\r\n");
        }
    };
    WindowPage page;
    page.connectToServer("127.0.0.1", server.port());
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.doubleClickStartPose(page.map().content().start_poses.front().name);
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.robot(1)->figures.spawned, soon_ms);
    QCOMPARE(shownLength_m(page), 0.0); // A mark until then.
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(shownLength_m(page) - 1.7) < 1e-6, soon_ms);
    QCOMPARE(server.heardOf("GETGEO {Type Robot}").size(), 1);
}

USAR_TEST(tst_WindowMap)

} // namespace tst_window_map

#include "tst_window_map.moc"
