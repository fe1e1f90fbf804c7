// Several robots, and what belongs to each of them, in the real window.
#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>
#include <QTreeView>

#include "tests/e2e/gui_watchdog.h"
#include "tests/e2e/inspector_page.h"
#include "tests/e2e/scratch_files.h"
#include "tests/e2e/window_page.h"
#include "tests/suite/suite.h"

namespace tst_window_robots {

using namespace usar;

namespace {

QJsonObject summaryIn(const QString& folder) {
    QFile file(QDir(folder).filePath(filesIn(folder, ".json").value(0)));
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
}

/// Up to the first piece of map.
bool fliesAndScans(WindowPage& page, const Rectangle& area) {
    if (!page.spawnAt("PlayerStart"))
        return false;
    page.pressKey(Qt::Key_A);
    page.drawArea(area);
    page.chooseSpeed("max");
    page.press("Start");
    return QTest::qWaitFor([&] { return page.knownTiles() >= 1; }, flight_ms);
}

} // namespace

class tst_WindowRobots : public QObject {
    Q_OBJECT
private slots:
    void init() { GuiWatchdog::instance().reset(); }
    void cleanup() { QVERIFY2(GuiWatchdog::instance().complaint().isEmpty(), GuiWatchdog::instance().complaint()); }
    void parametersOfAMissionFileSurviveSpawning();
    void eachRobotKeepsItsSettingsAndItsPause();
    void aDoubleClickedSensorValueIsPlotted();
    void oneCommandIsForAllThatAreMarked();
    void nobodyGetsANameTwice();
    void removingARobotSavesItsScan();
    void disconnectingSavesEveryScan();
    void eachSavedScanIsANoteOfItsOwn();
    void theEndIsInTheSummaryAndTimeIsRealAgain();
    void aRobotWithoutABehaviorIsSpawnedAndDrivenByCommands();
    void anotherWorldIsChosenFromTheMenu();
};

void tst_WindowRobots::parametersOfAMissionFileSurviveSpawning() {
    QTemporaryDir folder;
    const QString file = folder.filePath("mission.json");
    QFile json(file);
    QVERIFY(json.open(QIODevice::WriteOnly));
    json.write(R"({"name": "small", "area": {"x": -10, "y": -8, "width": 20, "height": 16},
                   "preset": "exact", "parameters": {"scan_altitude_m": 7.5, "maximum_scan_tilt_rad": 10}})");
    json.close();
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.window().mission().openMission(file);
    QVERIFY2(!page.notified("Mission small is ready").isEmpty(), qPrintable(page.notified({})));
    QVERIFY(page.spawnAt("PlayerStart"));
    const auto values = page.window().views().parameters->values();
    QCOMPARE(std::get<double>(values.at("scan_altitude_m")), 7.5);
    QCOMPARE(std::get<double>(values.at("scan_speed_m_s")), 2.0); // by the preset
    QVERIFY(qAbs(std::get<double>(values.at("maximum_scan_tilt_rad")) - radians(10.0)) < 1e-6);
    QVERIFY(page.map().area().has_value());
    QVERIFY(!page.map().content().area.lanes_in_map_m.empty());
}

void tst_WindowRobots::eachRobotKeepsItsSettingsAndItsPause() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    page.typeArea({{-20, -15}, {20, 15}});
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->figures.behavior_running, soon_ms);
    page.pressKey(Qt::Key_P);
    QTRY_VERIFY(page.robot(1)->paused);
    const auto* other_pose = &page.map().content().start_poses.back();
    QVERIFY(other_pose->name != "PlayerStart");
    QVERIFY(page.spawnAt(other_pose->name));
    QCOMPARE(page.window().selectedRobot(), RobotId{2});
    QVERIFY(!page.robot(2)->paused);
    page.typeArea({{30, 30}, {50, 40}});
    page.pressKey(Qt::Key_1);
    QCOMPARE(page.window().selectedRobot(), RobotId{1});
    QCOMPARE(page.map().area()->max_m.x(), 20.0);
    page.press("Resume");
    QTRY_VERIFY(!page.robot(1)->paused);
    page.pressKey(Qt::Key_2);
    QCOMPARE(page.map().area()->max_m.x(), 50.0);
    QCOMPARE(page.window().views().behavior->area().max_m.x(), 50.0);
}

void tst_WindowRobots::oneCommandIsForAllThatAreMarked() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    const auto poses = page.map().content().start_poses;
    for (int id = 1; id <= 3; ++id) {
        QVERIFY(page.spawnAt(poses[std::size_t(id - 1)].name));
        page.typeArea({{10.0 * id, -8}, {10.0 * id + 8.0, 8}});
    }
    auto* const list = page.window().views().robots->findChild<QListView*>();
    const auto mark = [&](int row, Qt::KeyboardModifiers keys) {
        QTest::mouseClick(list->viewport(), Qt::LeftButton, keys,
                          list->visualRect(list->model()->index(row, 0)).center());
    };
    const auto running = [&](int id) { return page.window().control().robot({id})->running(); };
    mark(0, {});
    mark(1, Qt::ControlModifier);
    QCOMPARE(page.window().selectedRobot(), RobotId{2});
    page.press("Start");
    QTRY_VERIFY_WITH_TIMEOUT(running(1) && running(2), soon_ms);
    QVERIFY(!running(3));
    QCOMPARE(page.robot(1)->area_in_map.min_m.x(), 10.0); // Each flies its own task.
    QCOMPARE(page.robot(2)->area_in_map.min_m.x(), 20.0);
    page.press("Pause");
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->paused && page.robot(2)->paused, soon_ms);
    page.press("Resume");
    QTRY_VERIFY_WITH_TIMEOUT(!page.robot(1)->paused && !page.robot(2)->paused, soon_ms);
    page.pressKey(Qt::Key_L);
    auto* const question = page.window().views().question;
    QCOMPARE(question->openQuestion(), QString("mission.land"));
    bool named = false;
    for (const QLabel* label : question->findChildren<QLabel*>())
        named |= label->text().contains("Land R1 and R2 here and now?");
    QVERIFY(named);
    question->give(1);
    page.pressKey(Qt::Key_1); // R1 alone.
    page.press("Stop");
    QTRY_VERIFY_WITH_TIMEOUT(!running(1), soon_ms);
    QVERIFY(running(2));
}

void tst_WindowRobots::aDoubleClickedSensorValueIsPlotted() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    auto* tree = page.window().views().sensors->findChild<QTreeView*>();
    const auto leaf = [tree] {
        const auto sources = tree->model()->match(tree->model()->index(0, 0), Qt::DisplayRole, "GroundTruth");
        return sources.isEmpty() ? QModelIndex() : tree->model()->index(0, 0, sources.front());
    };
    QTRY_VERIFY_WITH_TIMEOUT(leaf().isValid(), soon_ms);
    tree->scrollTo(leaf());
    const QPoint at = tree->visualRect(leaf()).center();
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, at);
    QTest::mouseDClick(tree->viewport(), Qt::LeftButton, {}, at);
    const auto* plots = page.window().views().plots;
    QTRY_COMPARE_WITH_TIMEOUT(plots->store().series().size(), 1U, soon_ms);
    const auto samples = [plots] { return plots->store().series().front().samples.size(); };
    QTRY_VERIFY_WITH_TIMEOUT(samples() >= 5, soon_ms);
}

/// A P2AT, which no plugin drives: chosen on the card, driven from the command box.
void tst_WindowRobots::aRobotWithoutABehaviorIsSpawnedAndDrivenByCommands() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    page.clickStartPose("PlayerStart");
    auto* const card = page.window().views().spawn_card;
    QTRY_VERIFY(card->isVisible());
    auto* const classes = card->findChild<QComboBox*>();
    QVERIFY(classes);
    classes->setFocus();
    for (int i = 0; classes->currentText() != "P2AT" && i < classes->count(); ++i)
        QTest::keyClick(classes, Qt::Key_Down);
    QCOMPARE(classes->currentText(), QString("P2AT"));
    page.press("Spawn");
    const auto speaks = [&] {
        const mission::RobotView* robot = page.robot(1);
        return robot && robot->figures.spawned;
    };
    QTRY_VERIFY_WITH_TIMEOUT(speaks(), soon_ms);
    QVERIFY(page.window().views().behavior->behaviorId().empty()); // not an AirRobot's
    QVERIFY(!page.window().commands().action("mission.start")->isEnabled());
    InspectorPage inspector(page);
    page.pressKey(Qt::Key_F4);
    inspector.type("DRIVE {Left 5} {Right 5}");
    inspector.press(Qt::Key_Return);
    const auto away_m = [&] {
        const auto& marks = page.map().content().robots;
        const auto one = marks.find(QString("R1"));
        return one == marks.end() ? 0.0 : one->second.robot.base_in_map.position_m.head<2>().norm();
    };
    QTRY_VERIFY_WITH_TIMEOUT(away_m() > 0.5, soon_ms);
}

void tst_WindowRobots::anotherWorldIsChosenFromTheMenu() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.window().commands().contains("world.spqr_soccer"));
    page.window().commands().action("world.spqr_soccer")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(page.connectionText().contains("spqr_soccer"), soon_ms);
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.window().control().robots().empty());
}

void tst_WindowRobots::nobodyGetsANameTwice() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(page.spawnAt("PlayerStart"));
    QTRY_VERIFY_WITH_TIMEOUT(page.window().views().connection->statusText().contains("tall_test"), soon_ms);
    mission::SpawnRequest twin;
    twin.robot_name = "R1";
    const auto again = page.window().control().spawn(twin);
    QVERIFY(!again);
    QVERIFY(QString::fromStdString(again.error().text()).contains("R1"));
}

void tst_WindowRobots::removingARobotSavesItsScan() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(fliesAndScans(page, {{-20, -15}, {20, 15}}));
    page.window().commands().action("robot.remove")->trigger();
    QVERIFY(page.window().control().robots().empty());
    QTRY_COMPARE_WITH_TIMEOUT(filesIn(page.resultFolder(), ".bil").size(), 1, soon_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!page.window().control().anythingToSave(), soon_ms);
}

void tst_WindowRobots::disconnectingSavesEveryScan() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(fliesAndScans(page, {{-20, -15}, {20, 15}}));
    page.press("Disconnect");
    QTRY_COMPARE_WITH_TIMEOUT(filesIn(page.resultFolder(), ".bil").size(), 1, soon_ms);
    page.press("Connect");
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(!page.map().area());
}

/// Defect D19 of the review: the saving of nine robots was one line, and it had the path of the first one.
void tst_WindowRobots::eachSavedScanIsANoteOfItsOwn() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    for (const char* const pose : {"PlayerStart", "HillTop"})
        QVERIFY(page.spawnAt(pose));
    for (const int id : {1, 2}) {
        page.pressKey(id == 1 ? Qt::Key_1 : Qt::Key_2);
        QCOMPARE(page.window().selectedRobot(), RobotId{id});
        const Vec2 at_m = page.robot(id)->spawn.start_in_map.position_m.head<2>();
        page.typeArea({at_m - Vec2(12, 9), at_m + Vec2(12, 9)});
        page.press("Start");
        QTRY_VERIFY_WITH_TIMEOUT(page.robot(id)->figures.behavior_running, soon_ms);
    }
    page.chooseSpeed("max");
    QTRY_VERIFY_WITH_TIMEOUT(!page.robot(1)->tiles.empty() && !page.robot(2)->tiles.empty(), flight_ms);
    page.press("Disconnect");
    for (const QString& name : {QString("R1"), QString("R2")})
        QTRY_VERIFY2_WITH_TIMEOUT(!page.notified("Saved the scan of " + name + ":").isEmpty(), qPrintable(name),
                                  soon_ms);
    QTRY_VERIFY_WITH_TIMEOUT(!page.window().control().anythingToSave(), soon_ms);
    for (const QString& name : {QString("R1"), QString("R2")}) // One does not replace the other.
        QVERIFY2(!page.notified("Saved the scan of " + name + ":").isEmpty(), qPrintable(name));
    const auto* const model = page.window().views().notifications->model();
    int open = 0;
    for (int row = 0; row < model->rowCount(); ++row)
        open += !model->row(row).cured && model->row(row).severity != Severity::Note ? 1 : 0;
    QCOMPARE(model->openCount(), open); // A note is no problem.
}

void tst_WindowRobots::theEndIsInTheSummaryAndTimeIsRealAgain() {
    WindowPage page;
    QTRY_VERIFY_WITH_TIMEOUT(page.hasStartPoses(), soon_ms);
    QVERIFY(fliesAndScans(page, {{-8, -6}, {8, 6}}));
    QTRY_VERIFY_WITH_TIMEOUT(page.robot(1)->finished.has_value(), flight_ms);
    QTRY_COMPARE_WITH_TIMEOUT(filesIn(page.resultFolder(), ".json").size(), 1, soon_ms);
    const QJsonObject summary = summaryIn(page.resultFolder());
    QVERIFY(summary["success"].toBool());
    QCOMPARE(summary["reason"].toString().toStdString(), page.robot(1)->finished->reason);
    QVERIFY(summary["duration_s"].toDouble() > 30.0);
    QCOMPARE(page.window().views().time->speed(), 1.0);
}

USAR_TEST(tst_WindowRobots)

} // namespace tst_window_robots

#include "tst_window_robots.moc"
