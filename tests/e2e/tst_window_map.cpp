// What is in the world and in the air, as the map of the real window shows it: robots at their true size.
#include <algorithm>

#include <QTcpSocket>
#include <QTest>
#include <QTimer>
#include <QToolButton>

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
    void ballIsSeenWhereItIs();
    void treesAreALayer();
    void theSpawnCardEndsWithItsServer();
    void robotIsPlacedByADragAndUndoTakesItAway();
    void whatWasStartedIsInSight();
};

/// Defect D9 of the review: after Start the map showed the area, and the robot that was started was out of the view.
void tst_WindowMap::whatWasStartedIsInSight() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    const auto& poses = page.map().content().start_poses;
    const auto farthest = std::ranges::max_element(
        poses, {}, [](const protocol::StartPose& pose) { return pose.pose_in_map.position_m.head<2>().norm(); });
    QVERIFY(page.spawnAt(farthest->name));
    page.typeArea({{-20, -15}, {20, 15}});
    widgets::MapTransform away = page.map().transform();
    away.center_m = Vec2(0.0, 0.0);
    away.pixels_per_m = 40.0; // Not even the edges of the area are in sight.
    page.map().setTransform(away);
    page.press("Start");
    const auto seen = [&](const Vec2& at_m) {
        return QRectF(page.map().rect()).contains(page.map().transform().toScreen(at_m));
    };
    const Vec2 robot_m = page.map().content().robots.at("R1").robot.base_in_map.position_m.head<2>();
    QTRY_VERIFY(seen(robot_m));
    for (const Vec2& corner_m : {Vec2(-20, -15), Vec2(20, -15), Vec2(-20, 15), Vec2(20, 15)})
        QVERIFY2(seen(corner_m), qPrintable(QStringLiteral("%1 %2").arg(corner_m.x()).arg(corner_m.y())));
}

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

/// Nobody has opened the dock of the world, so the window has no world controller.
void tst_WindowMap::ballIsSeenWhereItIs() {
    WindowPage page;
    quint16 port = 0;
    connect(&page.window().control().simulator(), &server::SimulatorHost::ready, &page.window(),
            [&](quint16 bots) { port = bots; });
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.window().views().world_dock->hide();
    page.window().commands().action("world.spqr_soccer")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(page.connectionText().contains("spqr_soccer"), soon_ms);
    const auto ball = [&] { return page.map().content().object("Ball"); };
    QTRY_VERIFY_WITH_TIMEOUT(ball(), soon_ms);
    QVERIFY(ball()->form == widgets::ObjectForm::Sphere && ball()->kind == "SoccerBall");
    QVERIFY(ball()->body_in_map.position_m.head<2>().norm() < 0.01);
    QTcpSocket other;
    other.connectToHost(QHostAddress::LocalHost, port);
    QVERIFY(other.waitForConnected());
    other.write("INIT {ClassName USARBot.WorldController} {Name Other}\r\n"
                "CONTROL {Type AbsMove} {Name Ball} {Location 1.5,-0.5,-0.3}\r\n");
    QTRY_VERIFY_WITH_TIMEOUT((ball()->body_in_map.position_m.head<2>() - Vec2(1.5, 0.5)).norm() < 0.1, soon_ms);
    QTRY_VERIFY_WITH_TIMEOUT(ball()->body_in_map.position_m.z() < 0.1, soon_ms); // It falls.
    page.window().control().disconnectFromServer();
    QTRY_VERIFY_WITH_TIMEOUT(!ball(), soon_ms);
}

void tst_WindowMap::treesAreALayer() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    const auto& scenery = page.map().content().scenery;
    QVERIFY(scenery && scenery->trees.size() > 1000 && !scenery->buildings.empty());
    widgets::MapTransform near = page.map().transform();
    near.center_m = scenery->trees.front().center_m;
    near.pixels_per_m = 20.0;
    page.map().setTransform(near);
    const QPoint at = page.map().transform().toScreen(near.center_m).toPoint() + QPoint(8, 8);
    const auto color = [&] { return page.map().grab().toImage().pixelColor(at); };
    const QColor with = color();
    auto* const layers = page.window().views().layers;
    QToolButton* eye = nullptr;
    for (QToolButton* button : layers->findChildren<QToolButton*>())
        if (button->accessibleName() == "Show Trees, objects")
            eye = button;
    QVERIFY(eye);
    eye->click();
    QVERIFY(color() != with);
    eye->click();
    QCOMPARE(color(), with);
}

/// The start poses of the next server are others.
void tst_WindowMap::theSpawnCardEndsWithItsServer() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    auto* const card = page.window().views().spawn_card;
    page.clickStartPose("PlayerStart");
    QTRY_VERIFY(card->isVisible());
    page.connectToServer("127.0.0.1", 9);
    QTRY_VERIFY(!card->isVisible());
}

void tst_WindowMap::robotIsPlacedByADragAndUndoTakesItAway() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    const auto& history = page.window().control().history();
    auto* const card = page.window().views().spawn_card;
    const auto& draft = page.map().content().spawn_draft_in_map;
    page.map().setFocus();
    page.pressKey(Qt::Key_R);
    QCOMPARE(page.map().tool(), widgets::MapTool::Robot);
    const auto& transform = page.map().transform();
    const QPoint from = QRectF(QPointF(), transform.viewport).center().toPoint() + QPoint(40, 30);
    const QPoint to = from + QPoint(60, -60);
    QTest::mousePress(&page.map(), Qt::LeftButton, {}, from);
    QTest::mouseMove(&page.map(), (from + to) / 2);
    QTest::mouseMove(&page.map(), to);
    QTest::mouseRelease(&page.map(), Qt::LeftButton, {}, to);
    QVERIFY(draft);
    const Pose drawn = *draft;
    QVERIFY((drawn.position_m.head<2>() - transform.toMap(from)).norm() * transform.pixels_per_m < 2.0);
    QVERIFY(std::abs(drawn.yaw_rad - bearingOf(transform.toMap(to) - transform.toMap(from))) < 0.05);
    QTRY_VERIFY(card->isVisible());
    QCOMPARE(card->choice().start_pose, widgets::SpawnChoice::at_draft);
    QCOMPARE(history.undoText(), QString("place robot"));
    page.pressKey(Qt::Key_Z, Qt::ControlModifier); // One step.
    QVERIFY(!draft && !card->isVisible() && !history.canUndo());
    page.window().commands().action("edit.redo")->trigger(); // Its key differs between platforms.
    QVERIFY(draft == drawn && card->isVisible());
    page.press("Spawn");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1) && page.robot(1)->figures.spawned && page.robot(1)->base_in_map, soon_ms);
    const Pose base = *page.robot(1)->base_in_map;
    QVERIFY((base.position_m.head<2>() - drawn.position_m.head<2>()).norm() < 1.0);
    QVERIFY(std::abs(normalizedAngle(base.yaw_rad - drawn.yaw_rad)) < 0.2);
    QVERIFY(!draft && !history.canUndo()); // A robot is not taken back by Undo.
}

USAR_TEST(tst_WindowMap)

} // namespace tst_window_map

#include "tst_window_map.moc"
