// Missions of every robot, opened in the real window and begun there.
#include <algorithm>

#include <QDir>
#include <QElapsedTimer>
#include <QLabel>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>

#include "core/mission/files/mission_file.h"
#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/scratch_files.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"

namespace tst_window_missions {

using namespace usar;

namespace {

constexpr const char* missions_folder = USAR_SOURCE_DIR "/resources/missions";

QString shipped(const QString& name) {
    return QDir(missions_folder).filePath(name + ".json");
}

} // namespace

class tst_WindowMissions : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void aMissionBringsItsWorldAndItsRobot_data();
    void aMissionBringsItsWorldAndItsRobot();
    void theStartPoseOfAMissionIsInView();
    void theTitleTellsHowFarTheMissionIs();
    void aMissionForAnotherRobotWaitsForOne();
    void aRobotThatIsThereFliesTheMissionsParameters();
    void aWorldWithARobotInItIsNotLeft();
    void anotherWorldThanTheMissionsForgetsIt();
};

void tst_WindowMissions::aMissionBringsItsWorldAndItsRobot_data() {
    QTest::addColumn<QString>("name");
    for (const QString& file : QDir(missions_folder).entryList({"*.json"}, QDir::Files))
        QTest::newRow(qPrintable(file)) << file.chopped(5);
}

void tst_WindowMissions::aMissionBringsItsWorldAndItsRobot() {
    QFETCH(QString, name);
    const auto mission = mission::readMissionFile(shipped(name));
    QVERIFY(mission.has_value());
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.dropFile(shipped(name)));
    QTRY_VERIFY2_WITH_TIMEOUT(!page.notified("is ready").isEmpty(), qPrintable(page.notified({})), 2 * soon_ms);
    const QString ready = page.notified("is ready");
    QVERIFY2(ready.contains(QString::fromStdString(mission->name)), qPrintable(ready));
    QVERIFY2(ready.contains(QString::fromStdString(mission->robot_class).section('.', -1)), qPrintable(ready));
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt(mission->start));
    QCOMPARE(page.robot(1)->spawn.class_name, mission->robot_class);
    QCOMPARE(page.window().views().behavior->behaviorId(), mission->behavior);
    page.press("Start");
    QTRY_VERIFY2_WITH_TIMEOUT(page.robot(1)->figures.behavior_running && page.robot(1)->status,
                              qPrintable(page.notified({})), soon_ms);
    QCOMPARE(page.robot(1)->behavior_id, mission->behavior);
    QVERIFY2(!page.robot(1)->finished, page.robot(1)->finished ? page.robot(1)->finished->reason.c_str() : "");
}

void tst_WindowMissions::theStartPoseOfAMissionIsInView() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    const QTemporaryDir folder;
    page.window().mission().openMission(
        fileIn(folder, "volcano.json",
               R"({ "name": "Volcano", "world": "volcano", "robot": "USARBot.AirRobot", "start": "NorthFoot",
        "behavior": "airrobot/cpp", "area": { "x": -60, "y": 20, "width": 60, "height": 40 } })"));
    QTRY_VERIFY2_WITH_TIMEOUT(!page.notified("is ready").isEmpty(), qPrintable(page.notified({})), 2 * soon_ms);
    const auto& poses = page.map().content().start_poses;
    const auto start = std::ranges::find(poses, "NorthFoot", &protocol::StartPose::name);
    QVERIFY(start != poses.end());
    const Rectangle seen = page.map().transform().visible();
    QVERIFY(seen.contains(start->pose_in_map.position_m.head<2>()));
    QVERIFY(seen.contains(Vec2(-60.0, 20.0)) && seen.contains(Vec2(0.0, 60.0)));
}

/// In whole units, and no more than once a second however fast time goes: a taskbar draws each title.
void tst_WindowMissions::theTitleTellsHowFarTheMissionIs() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.dropFile(shipped("quick_scan")));
    QVERIFY(page.spawnAt("PlayerStart"));
    const QString idle = page.window().windowTitle();
    page.chooseSpeed("10×");
    QSignalSpy titles(&page.window(), &QWidget::windowTitleChanged);
    QElapsedTimer since;
    since.start();
    page.press("Start");
    static const QRegularExpression all("^\\d+ % · .+ · [1-9]\\d* % covered · \\d+ m traveled · [\\d:]+ elapsed · "
                                        "[\\d:]+ left · \\d+ m range left – ");
    QTRY_VERIFY2_WITH_TIMEOUT(page.window().windowTitle().contains(all), qPrintable(page.window().windowTitle()),
                              flight_ms);
    QVERIFY(page.window().windowTitle().endsWith(" – " + idle));
    QVERIFY2(titles.size() <= since.elapsed() / 1000 + 3, qPrintable(QString::number(titles.size())));
    page.window().commands().action("mission.stop")->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(page.window().windowTitle(), idle, soon_ms);
}

void tst_WindowMissions::aMissionForAnotherRobotWaitsForOne() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    QCOMPARE(page.robot(1)->spawn.class_name, "USARBot.AirRobot");
    page.window().mission().openMission(shipped("p2dx_meadow"));
    QTRY_VERIFY2_WITH_TIMEOUT(page.notified("is ready").contains("spawn the robot (P2DX)"),
                              qPrintable(page.notified({})), soon_ms);
    QCOMPARE(page.window().selectedRobot(), RobotId{0});
    const auto mission = mission::readMissionFile(shipped("p2dx_meadow"));
    QVERIFY(page.spawnAt(mission->start));
    QCOMPARE(page.robot(2)->spawn.class_name, "USARBot.P2DX");
    QCOMPARE(page.window().selectedRobot(), RobotId{2});
    QCOMPARE(page.window().views().behavior->behaviorId(), "p2dx/cpp");
    page.pressKey(Qt::Key_1); // and the first one has kept what it had
    QCOMPARE(page.window().views().behavior->behaviorId(), "airrobot/cpp");
}

/// The panel showed them, but the plan and the flight were those of the defaults.
void tst_WindowMissions::aRobotThatIsThereFliesTheMissionsParameters() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    const QTemporaryDir folder;
    page.window().mission().openMission(
        fileIn(folder, "fast.json",
               R"({ "name": "Fast", "world": "tall_test", "robot": "USARBot.AirRobot", "start": "PlayerStart",
        "behavior": "airrobot/cpp", "area": { "x": -30, "y": -20, "width": 60, "height": 40 }, "preset": "fast",
        "parameters": { "scan_altitude_m": 7 } })"));
    const auto shown = [&page](const QString& text) { return !page.notified(text).isEmpty(); };
    QTRY_VERIFY2_WITH_TIMEOUT(shown("is ready"), qPrintable(page.notified({})), soon_ms);
    const auto labels = page.window().views().behavior->findChildren<QLabel*>();
    QTRY_VERIFY_WITH_TIMEOUT(
        std::ranges::any_of(labels, [](const QLabel* label) { return label->text().startsWith("3 lanes · "); }),
        soon_ms);
    page.press("Start");
    QTRY_VERIFY2_WITH_TIMEOUT(page.robot(1)->figures.behavior_running && page.robot(1)->status,
                              qPrintable(page.notified({})), soon_ms);
    const auto& parameters = page.window().control().robot(RobotId{1})->started()->parameters;
    QCOMPARE(std::get<double>(parameters.at("scan_altitude_m")), 7.0);
    QCOMPARE(std::get<double>(parameters.at("transit_speed_m_s")), 2.0);
}

void tst_WindowMissions::aWorldWithARobotInItIsNotLeft() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    page.window().mission().openMission(shipped("ers_soccer"));
    QVERIFY2(!page.notified("this mission belongs to the world spqr_soccer").isEmpty(), qPrintable(page.notified({})));
    QVERIFY(page.robot(1)->figures.spawned);
}

void tst_WindowMissions::anotherWorldThanTheMissionsForgetsIt() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.window().mission().openMission(shipped("ers_soccer"));
    page.window().commands().action("world.vmac_room")->trigger();
    QTRY_VERIFY2_WITH_TIMEOUT(page.connectionText().contains("vmac_room"), qPrintable(page.connectionText()),
                              2 * soon_ms);
    QVERIFY(page.notified("is ready").isEmpty());
}

USAR_TEST(tst_WindowMissions)

} // namespace tst_window_missions

#include "tst_window_missions.moc"
