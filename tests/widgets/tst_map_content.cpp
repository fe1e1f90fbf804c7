#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/map/map_content.h"

namespace tst_map_content {

using namespace usar;
using namespace usar::widgets;

namespace {

MapObject named(const QString& name) {
    MapObject object;
    object.name = name;
    return object;
}

} // namespace

class tst_MapContent : public QObject {
    Q_OBJECT
private slots:
    void emptyUntilSomethingIsKnown_data();
    void emptyUntilSomethingIsKnown();
    void groundIsTheWorldOrAroundTheStartPoses();
    void forgetServerKeepsLayersAndTool();
    void stalePosesLeaveNoTrail();
    void selectedRobotMayNotBeThereYet();
    void missingObjectsAreLetGo();
    void startPosesAreSteppedThrough_data();
    void startPosesAreSteppedThrough();
    void smallObjectsAreLargeEnoughToClick();
};

void tst_MapContent::emptyUntilSomethingIsKnown_data() {
    QTest::addColumn<bool>("world");
    QTest::addColumn<bool>("start_pose");
    QTest::addColumn<bool>("robot");
    QTest::newRow("nothing") << false << false << false;
    QTest::newRow("a world") << true << false << false;
    QTest::newRow("a start pose") << false << true << false;
    QTest::newRow("a robot") << false << false << true;
}

void tst_MapContent::emptyUntilSomethingIsKnown() {
    QFETCH(bool, world);
    QFETCH(bool, start_pose);
    QFETCH(bool, robot);
    MapContent content;
    if (world)
        content.world_in_map = Rectangle{Vec2(0, 0), Vec2(1, 1)};
    if (start_pose)
        content.start_poses = {{"Only", {}}};
    if (robot)
        content.takeRobot({QStringLiteral("R1"), 1, {}});
    QCOMPARE(content.empty(), !world && !start_pose && !robot);
}

void tst_MapContent::groundIsTheWorldOrAroundTheStartPoses() {
    MapContent content;
    QVERIFY(content.groundInMap().empty());
    content.start_poses = {{"A", {{10, -5, 3}, 0, 0, 0}}, {"B", {{-30, 5, 0}, 0, 0, 0}}};
    QCOMPARE(content.groundInMap(), (Rectangle{Vec2(-50, -25), Vec2(30, 25)}));
    const Rectangle world{Vec2(-5, -5), Vec2(5, 5)};
    content.world_in_map = world;
    QCOMPARE(content.groundInMap(), world);
}

void tst_MapContent::forgetServerKeepsLayersAndTool() {
    MapContent content;
    content.layers[static_cast<std::size_t>(MapLayer::Grid)] = {false, 0.3};
    content.area.editing = true;
    content.area.area_in_map = content.world_in_map = Rectangle{Vec2(-5, -5), Vec2(5, 5)};
    content.area.hot_grip = AreaGrip{1, 1};
    content.selected_robot = QStringLiteral("R1");
    content.takeRobot({QStringLiteral("R1"), 1, {}});
    content.setObjects({named(QStringLiteral("C1"))});
    content.objects.held = QStringLiteral("C1");
    content.forgetServer();
    QVERIFY(content.empty() && !content.area.area_in_map && !content.area.hot_grip);
    QVERIFY(content.selected_robot.isEmpty() && content.objects.objects.empty() && content.objects.held.isEmpty());
    QVERIFY(content.area.editing);
    QCOMPARE(content.layer(MapLayer::Grid), (LayerState{false, 0.3}));
}

void tst_MapContent::stalePosesLeaveNoTrail() {
    MapContent content;
    content.takeRobot({QStringLiteral("R1"), 1, {{0, 0, 0}, 0, 0, 0}});
    content.takeRobot({QStringLiteral("R1"), 1, {{5, 0, 0}, 0, 0, 0}, true});
    QCOMPARE(content.robots.size(), std::size_t(1));
    QCOMPARE(content.robots.at(QStringLiteral("R1")).trail.points_m().size(), std::size_t(1));
    content.takeRobot({QStringLiteral("R1"), 1, {{9, 0, 0}, 0, 0, 0}});
    QCOMPARE(content.robots.at(QStringLiteral("R1")).trail.points_m().size(), std::size_t(2));
    QCOMPARE(content.robots.at(QStringLiteral("R1")).robot.base_in_map.position_m.x(), 9.0);
}

void tst_MapContent::selectedRobotMayNotBeThereYet() {
    MapContent content;
    content.selected_robot = QStringLiteral("R1");
    QVERIFY(!content.selectedRobot());
    content.takeRobot({QStringLiteral("R1"), 4, {}});
    QVERIFY(content.selectedRobot());
    QCOMPARE(content.selectedRobot()->number, 4);
}

void tst_MapContent::missingObjectsAreLetGo() {
    MapContent content;
    content.setObjects({named(QStringLiteral("C1")), named(QStringLiteral("C2"))});
    content.objects.selected = QStringLiteral("C1");
    content.objects.held = QStringLiteral("C2");
    content.setObjects({named(QStringLiteral("C2"))});
    QVERIFY(content.objects.selected.isEmpty());
    QCOMPARE(content.objects.held, QStringLiteral("C2"));
    QVERIFY(content.object(QStringLiteral("C2")) && !content.object(QStringLiteral("C1")));
    content.setObjects({});
    QVERIFY(content.objects.held.isEmpty());
}

void tst_MapContent::startPosesAreSteppedThrough_data() {
    QTest::addColumn<int>("count");
    QTest::addColumn<int>("hot");
    QTest::addColumn<int>("by");
    QTest::addColumn<int>("then_hot");
    QTest::newRow("none") << 0 << -1 << 1 << -1;
    QTest::newRow("first") << 3 << -1 << 1 << 0;
    QTest::newRow("last") << 3 << -1 << -1 << 2;
    QTest::newRow("next") << 3 << 0 << 1 << 1;
    QTest::newRow("around the end") << 3 << 2 << 1 << 0;
    QTest::newRow("around the beginning") << 3 << 0 << -1 << 2;
    QTest::newRow("the only one") << 1 << 0 << 1 << 0;
}

void tst_MapContent::startPosesAreSteppedThrough() {
    QFETCH(int, count);
    QFETCH(int, hot);
    QFETCH(int, by);
    QFETCH(int, then_hot);
    MapContent content;
    for (int i = 0; i < count; ++i)
        content.start_poses.push_back({std::to_string(i), {}});
    if (hot >= 0)
        content.hot_start_pose = static_cast<std::size_t>(hot);
    const protocol::StartPose* const pose = content.stepStartPose(by);
    QCOMPARE(pose ? std::stoi(pose->name) : -1, then_hot);
    QCOMPARE(content.hot_start_pose ? static_cast<int>(*content.hot_start_pose) : -1, then_hot);
}

void tst_MapContent::smallObjectsAreLargeEnoughToClick() {
    const MapObject object = movedTo(named(QStringLiteral("C1")), Vec2(20, 10));
    MapTransform transform;
    transform.pixels_per_m = 100.0;
    QVERIFY(qAbs(outlineOnScreen(object, transform).boundingRect().width() - 100.0) < 1e-6);
    transform.pixels_per_m = 0.5;
    const QRectF small = outlineOnScreen(object, transform).boundingRect();
    QVERIFY(qAbs(small.width() - 10.0) < 1e-6);
    QVERIFY((small.center() - transform.toScreen(Vec2(20, 10))).manhattanLength() < 1e-6);
}

USAR_TEST(tst_MapContent)

} // namespace tst_map_content

#include "tst_map_content.moc"
