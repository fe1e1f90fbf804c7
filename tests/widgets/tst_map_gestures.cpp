#include <cmath>

#include <QMimeData>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/map/map_gestures.h"
#include "widgets/map/spawn_choice.h"

namespace tst_map_gestures {

using namespace usar;
using namespace usar::widgets;

namespace {

MapObject crate(const QString& name, const Vec2& at_m) {
    MapObject object;
    object.name = name;
    object.kind = QStringLiteral("Crate");
    object.body_in_map.position_m = {at_m.x(), at_m.y(), 0.5};
    return object;
}

/// A plain widget of 400 x 400 pixels with gestures on it: 10 pixels a meter, the origin in the middle, y up.
struct Ground {
    QWidget widget;
    MapContent content;
    MapTransform transform{MapOrientation::YUp, Vec2::Zero(), 10.0, QSizeF(400.0, 400.0)};
    MapGestures gestures{widget, content, transform};
    Qt::MouseButtons held = Qt::NoButton;

    Ground() {
        widget.resize(400, 400);
        widget.setMouseTracking(true);
        widget.show();
        static_cast<void>(QTest::qWaitForWindowExposed(&widget));
        content.world_in_map = Rectangle{Vec2(-15, -15), Vec2(15, 15)};
    }
    QPoint screen(double x_m, double y_m) const { return transform.toScreen(Vec2(x_m, y_m)).toPoint(); }
    void press(const QPoint& at, Qt::MouseButton button = Qt::LeftButton) {
        held = button;
        QTest::mousePress(&widget, button, {}, at);
    }
    void release(const QPoint& at, Qt::KeyboardModifiers modifiers = {}) {
        held = Qt::NoButton;
        QTest::mouseRelease(&widget, Qt::LeftButton, modifiers, at);
    }
    /// QTest moves the cursor of the screen instead, and a platform without a screen may say nothing of it.
    void move(const QPoint& at, Qt::KeyboardModifiers modifiers = {}) {
        QMouseEvent event(QEvent::MouseMove, at, widget.mapToGlobal(at), Qt::NoButton, held, modifiers);
        QCoreApplication::sendEvent(&widget, &event);
    }
    /// Presses and moves, and does not release.
    void pull(const QPoint& from, const QPoint& to) {
        press(from);
        move((from + to) / 2);
        move(to);
    }
    template <class Event>
    bool drag(const QPoint& at, const QMimeData& data) {
        Event event(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        event.ignore();
        QCoreApplication::sendEvent(&widget, &event);
        return event.isAccepted();
    }
};

} // namespace

class tst_MapGestures : public QObject {
    Q_OBJECT
private slots:
    void leftPressPansOnlyIfItMoves();
    void otherButtonsPanWithEveryTool_data();
    void otherButtonsPanWithEveryTool();
    void gestureLastsFromPressToRelease();
    void areaIsDrawnGrippedAndMoved_data();
    void areaIsDrawnGrippedAndMoved();
    void cancelBringsTheAreaBackAndForgetDoesNot();
    void changeOfToolCancels();
    void clicksFindTheUppermost();
    void objectGoesWithTheHand();
    void objectThatHasLeftIsNotMoved();
    void toolsPlaceWhereTheClickIs();
    void ghostIsUnderTheCursorWhileSomethingCanBePlaced();
    void onlyObjectsAreDraggedIn();
    void cursorSaysWhatAPressWouldDo();
    void disabledWidgetHasNoGestures();
    void toolTipsDescribeWhatIsThere();
    void robotIsPlacedAndTurned_data();
    void robotIsPlacedAndTurned();
    void placingIsCanceledAndTakenAway();
    void placedRobotIsClicked();
    void lineIsMeasuredUntilTheToolIsLeft();
    void aRectangleIsMeasuredWithShift();
    void theWriterIsAskedForOnTheGroundOnly();
};

void tst_MapGestures::leftPressPansOnlyIfItMoves() {
    Ground ground;
    QSignalSpy panned(&ground.gestures, &MapGestures::panned);
    ground.press({100, 100});
    ground.release({100, 100});
    QCOMPARE(panned.count(), 0);
    ground.pull({100, 100}, {140, 90});
    ground.release({140, 90});
    QPointF sum;
    for (const auto& by : panned)
        sum += by[0].toPointF();
    QCOMPARE(sum, QPointF(40, -10));
}

void tst_MapGestures::otherButtonsPanWithEveryTool_data() {
    QTest::addColumn<int>("tool");
    QTest::addColumn<Qt::MouseButton>("button");
    for (const MapTool tool : {MapTool::Pan, MapTool::Area, MapTool::Place, MapTool::Waypoint, MapTool::Robot})
        for (const Qt::MouseButton button : {Qt::MiddleButton, Qt::RightButton})
            QTest::addRow("tool %d, button %d", int(tool), int(button)) << int(tool) << button;
}

void tst_MapGestures::otherButtonsPanWithEveryTool() {
    QFETCH(int, tool);
    QFETCH(Qt::MouseButton, button);
    Ground ground;
    ground.gestures.setTool(static_cast<MapTool>(tool));
    QSignalSpy panned(&ground.gestures, &MapGestures::panned);
    ground.press({100, 100}, button);
    ground.move({103, 104});
    QCOMPARE(panned.count(), 1);
    QCOMPARE(panned[0][0].toPointF(), QPointF(3, 4));
}

void tst_MapGestures::gestureLastsFromPressToRelease() {
    Ground ground;
    QVERIFY(!ground.gestures.inProgress());
    ground.press({100, 100});
    QVERIFY(ground.gestures.inProgress());
    ground.release({100, 100});
    QVERIFY(!ground.gestures.inProgress());
    ground.pull({100, 100}, {140, 90});
    ground.gestures.cancel();
    QVERIFY(!ground.gestures.inProgress());
    QSignalSpy panned(&ground.gestures, &MapGestures::panned);
    ground.move({150, 80});
    QCOMPARE(panned.count(), 0);
}

void tst_MapGestures::areaIsDrawnGrippedAndMoved_data() {
    QTest::addColumn<QPointF>("from_m");
    QTest::addColumn<QPointF>("to_m");
    QTest::addColumn<QPointF>("min_m");
    QTest::addColumn<QPointF>("max_m");
    QTest::newRow("a new one") << QPointF(8, 8) << QPointF(12, 10) << QPointF(8, 8) << QPointF(12, 10);
    QTest::newRow("not beyond the world") << QPointF(8, 8) << QPointF(19, 10) << QPointF(8, 8) << QPointF(15, 10);
    QTest::newRow("its corner") << QPointF(5, 5) << QPointF(9, 7) << QPointF(-5, -5) << QPointF(9, 7);
    QTest::newRow("its left side") << QPointF(-5, 0) << QPointF(-8, 3) << QPointF(-8, -5) << QPointF(5, 5);
    QTest::newRow("all of it") << QPointF(0, 1) << QPointF(2, 4) << QPointF(-3, -2) << QPointF(7, 8);
}

void tst_MapGestures::areaIsDrawnGrippedAndMoved() {
    QFETCH(QPointF, from_m);
    QFETCH(QPointF, to_m);
    QFETCH(QPointF, min_m);
    QFETCH(QPointF, max_m);
    Ground ground;
    ground.content.area.area_in_map = Rectangle{Vec2(-5, -5), Vec2(5, 5)};
    ground.gestures.setTool(MapTool::Area);
    QVERIFY(ground.content.area.editing);
    QSignalSpy edited(&ground.gestures, &MapGestures::areaEdited);
    QSignalSpy changed(&ground.gestures, &MapGestures::areaChanged);
    ground.pull(ground.screen(from_m.x(), from_m.y()), ground.screen(to_m.x(), to_m.y()));
    QVERIFY(edited.count() > 0);
    QCOMPARE(changed.count(), 0);
    ground.release(ground.screen(to_m.x(), to_m.y()));
    const Rectangle wanted{Vec2(min_m.x(), min_m.y()), Vec2(max_m.x(), max_m.y())};
    QCOMPARE(changed.count(), 1);
    QCOMPARE(changed[0][0].value<Rectangle>(), wanted);
    QCOMPARE(ground.content.area.area_in_map, std::optional(wanted));
}

void tst_MapGestures::cancelBringsTheAreaBackAndForgetDoesNot() {
    const Rectangle before{Vec2(-5, -5), Vec2(5, 5)};
    for (const bool cancels : {true, false}) {
        Ground ground;
        ground.content.area.area_in_map = before;
        ground.gestures.setTool(MapTool::Area);
        ground.pull(ground.screen(5, 5), ground.screen(9, 7));
        QVERIFY(ground.content.area.area_in_map != std::optional(before));
        QSignalSpy edited(&ground.gestures, &MapGestures::areaEdited);
        if (cancels)
            ground.gestures.cancel();
        else
            ground.gestures.forget();
        QCOMPARE(ground.content.area.area_in_map == std::optional(before), cancels);
        QCOMPARE(edited.count(), cancels ? 1 : 0);
        QVERIFY(!ground.gestures.inProgress());
    }
}

void tst_MapGestures::changeOfToolCancels() {
    Ground ground;
    QSignalSpy tool(&ground.gestures, &MapGestures::toolChanged);
    ground.gestures.setTool(MapTool::Pan);
    QCOMPARE(tool.count(), 0);
    ground.gestures.setTool(MapTool::Area);
    ground.pull(ground.screen(1, 1), ground.screen(5, 5));
    QVERIFY(ground.content.area.area_in_map);
    ground.gestures.setTool(MapTool::Pan);
    QVERIFY(!ground.content.area.area_in_map && !ground.content.area.editing);
    QCOMPARE(tool.count(), 2);
}

void tst_MapGestures::clicksFindTheUppermost() {
    Ground ground;
    ground.content.takeRobot({QStringLiteral("R1"), 1, {{0, 0, 0}, 0, 0, 0}});
    ground.content.start_poses = {{"Here", {{0, 0, 0}, 0, 0, 0}}, {"There", {{8, 8, 0}, 0, 0, 0}}};
    ground.content.setObjects({crate("C1", {0, 0}), crate("C2", {-8, 0})});
    QSignalSpy robot(&ground.gestures, &MapGestures::robotClicked);
    QSignalSpy pose(&ground.gestures, &MapGestures::startPoseClicked);
    QSignalSpy object(&ground.gestures, &MapGestures::objectClicked);
    QSignalSpy spawn(&ground.gestures, &MapGestures::spawnRequested);
    const auto click = [&](double x_m, double y_m) {
        QTest::mouseClick(&ground.widget, Qt::LeftButton, {}, ground.screen(x_m, y_m));
    };
    click(0, 0);
    QCOMPARE(robot.count(), 1);
    QCOMPARE(ground.content.selected_robot, QStringLiteral("R1"));
    click(8, 8);
    QCOMPARE(pose.count(), 1);
    QCOMPARE(pose[0][0].value<std::size_t>(), std::size_t(1));
    click(-8, 0);
    QCOMPARE(ground.content.objects.selected, QStringLiteral("C2"));
    click(-8, -8);
    click(-8, -8); // Nothing is selected any more, so there is no news.
    QCOMPARE(ground.content.objects.selected, QString());
    QCOMPARE(object.count(), 2);
    QTest::mouseDClick(&ground.widget, Qt::LeftButton, {}, ground.screen(8, 8));
    QCOMPARE(spawn.count(), 1);
    QCOMPARE(spawn[0][0].toInt(), 1);
}

void tst_MapGestures::objectGoesWithTheHand() {
    Ground ground;
    ground.content.setObjects({crate("C1", {0, 0}), crate("C2", {4, 0})});
    QSignalSpy moved(&ground.gestures, &MapGestures::objectMoved);
    ground.pull(ground.screen(4.2, 0.2), ground.screen(7.2, 2.2));
    QCOMPARE(ground.content.objects.held, QStringLiteral("C2"));
    QCOMPARE(ground.content.objects.selected, QStringLiteral("C2"));
    QVERIFY(ground.content.objects.held_to_m.isApprox(Vec2(7, 2), 0.02));
    QCOMPARE(moved.count(), 0);
    ground.release(ground.screen(7.2, 2.2));
    QCOMPARE(moved.count(), 1);
    QVERIFY(ground.content.objects.held.isEmpty());
    const Vec3 now_m = ground.content.object("C2")->body_in_map.position_m;
    QVERIFY(now_m.isApprox(Vec3(7, 2, 0.5), 0.02));
}

void tst_MapGestures::objectThatHasLeftIsNotMoved() {
    Ground ground;
    ground.content.setObjects({crate("C1", {0, 0})});
    QSignalSpy moved(&ground.gestures, &MapGestures::objectMoved);
    ground.pull(ground.screen(0, 0), ground.screen(3, 0));
    ground.content.setObjects({crate("C2", {0, 0})});
    ground.release(ground.screen(3, 0));
    QCOMPARE(moved.count(), 0);
}

void tst_MapGestures::toolsPlaceWhereTheClickIs() {
    Ground ground;
    ground.content.start_poses = {{"Here", {{0, 0, 0}, 0, 0, 0}}};
    QSignalSpy placed(&ground.gestures, &MapGestures::placeRequested);
    QSignalSpy waypoint(&ground.gestures, &MapGestures::waypointAdded);
    QSignalSpy pose(&ground.gestures, &MapGestures::startPoseClicked);
    ground.gestures.setTool(MapTool::Place);
    ground.press(ground.screen(0, 0));
    ground.release(ground.screen(0, 0), Qt::ShiftModifier);
    QCOMPARE(placed.count(), 1);
    QVERIFY(placed[0][0].value<Vec2>().norm() < 0.1 && placed[0][1].toBool());
    ground.gestures.setTool(MapTool::Waypoint);
    ground.press(ground.screen(3, 4));
    ground.release(ground.screen(3, 4));
    QCOMPARE(waypoint.count(), 1);
    QVERIFY(waypoint[0][0].value<Vec2>().isApprox(Vec2(3, 4), 0.02));
    QCOMPARE(pose.count(), 0);
}

void tst_MapGestures::ghostIsUnderTheCursorWhileSomethingCanBePlaced() {
    Ground ground;
    ground.gestures.setGhost(crate("New", {0, 0}));
    ground.move(ground.screen(3, 4));
    QVERIFY2(!ground.content.objects.ghost, "a click would place nothing");
    ground.gestures.setTool(MapTool::Place);
    QVERIFY(ground.content.objects.ghost);
    QVERIFY(ground.content.objects.ghost->body_in_map.position_m.head<2>().isApprox(Vec2(3, 4), 0.02));
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&ground.widget, &leave);
    QVERIFY(!ground.content.objects.ghost && !ground.gestures.cursor_px());
}

void tst_MapGestures::onlyObjectsAreDraggedIn() {
    Ground ground;
    ground.gestures.setGhost(crate("New", {0, 0}));
    QSignalSpy placed(&ground.gestures, &MapGestures::placeRequested);
    QMimeData text;
    text.setText(QStringLiteral("C"));
    QVERIFY(!ground.drag<QDragEnterEvent>(ground.screen(1, 1), text));
    QMimeData object;
    object.setData(object_mime, "Crate");
    QVERIFY(ground.drag<QDragEnterEvent>(ground.screen(1, 1), object));
    QVERIFY(ground.content.objects.ghost);
    QVERIFY(ground.drag<QDragMoveEvent>(ground.screen(2, 5), object));
    QVERIFY(ground.content.objects.ghost->body_in_map.position_m.head<2>().isApprox(Vec2(2, 5), 0.02));
    QVERIFY(ground.drag<QDropEvent>(ground.screen(2, 5), object));
    QVERIFY(!ground.content.objects.ghost);
    QCOMPARE(placed.count(), 1);
    QVERIFY(!placed[0][1].toBool());
    QVERIFY2(!ground.drag<QDropEvent>(ground.screen(2, 5), object), "nothing came in before");
    QCOMPARE(placed.count(), 1);
}

void tst_MapGestures::cursorSaysWhatAPressWouldDo() {
    Ground ground;
    const auto shape = [&] { return ground.widget.cursor().shape(); };
    ground.content.start_poses = {{"There", {{8, 8, 0}, 0, 0, 0}}};
    ground.content.area.area_in_map = Rectangle{Vec2(-5, -5), Vec2(5, 5)};
    ground.move(ground.screen(-9, -9));
    QCOMPARE(shape(), Qt::ArrowCursor);
    ground.move(ground.screen(8, 8));
    QCOMPARE(shape(), Qt::PointingHandCursor);
    ground.press({50, 350}, Qt::MiddleButton);
    QCOMPARE(shape(), Qt::ClosedHandCursor);
    ground.gestures.cancel();
    ground.gestures.setTool(MapTool::Area);
    ground.move(ground.screen(-9, -9));
    QCOMPARE(shape(), Qt::CrossCursor);
    ground.move(ground.screen(5, 5));
    QCOMPARE(shape(), Qt::PointingHandCursor);
    ground.move(ground.screen(1, 1));
    QCOMPARE(shape(), Qt::SizeAllCursor);
}

void tst_MapGestures::disabledWidgetHasNoGestures() {
    Ground ground;
    ground.widget.setEnabled(false);
    ground.press({100, 100});
    QVERIFY(!ground.gestures.inProgress());
}

void tst_MapGestures::toolTipsDescribeWhatIsThere() {
    Ground ground;
    ground.content.takeRobot({QStringLiteral("R7"), 7, {{-8, -8, 1.5}, 0, 0, 0}});
    ground.content.start_poses = {{"There", {{8, 8, 0}, 0, 0, 0}}};
    ground.content.setObjects({crate("C1", {0, 0})});
    const MapHits hits(ground.content, ground.transform);
    QVERIFY(hits.toolTipAt(ground.screen(-8, -8)).contains(QStringLiteral("R7")));
    QVERIFY(hits.toolTipAt(ground.screen(8, 8)).contains(QStringLiteral("There")));
    QVERIFY(hits.toolTipAt(ground.screen(0, 0)).contains(QStringLiteral("Crate C1")));
    QCOMPARE(hits.toolTipAt(ground.screen(-8, 8)), QString());
    ground.content.takeRobot({QStringLiteral("R8"), 8, {{std::nan(""), 0, 0}, 0, 0, 0}});
    QCOMPARE(hits.robotAt(ground.screen(8, -8)), QString());
    ground.content.layers[static_cast<std::size_t>(MapLayer::StartPoses)].visible = false;
    QCOMPARE(hits.toolTipAt(ground.screen(8, 8)), QString());
}

void tst_MapGestures::robotIsPlacedAndTurned_data() {
    QTest::addColumn<double>("dx_m");
    QTest::addColumn<double>("dy_m");
    QTest::addColumn<double>("yaw_rad");
    QTest::newRow("a click looks along x") << 0.0 << 0.0 << 0.0;
    QTest::newRow("a hand that trembles, too") << 0.3 << 0.4 << 0.0;
    QTest::newRow("up") << 0.0 << 5.0 << pi / 2.0;
    QTest::newRow("down and left") << -4.0 << -4.0 << -0.75 * pi;
}

void tst_MapGestures::robotIsPlacedAndTurned() {
    QFETCH(double, dx_m);
    QFETCH(double, dy_m);
    QFETCH(double, yaw_rad);
    Ground ground;
    std::vector<std::pair<std::optional<Pose>, std::optional<Pose>>> placed;
    connect(&ground.gestures, &MapGestures::draftPlaced, this,
            [&](const auto& before, const auto& after) { placed.emplace_back(before, after); });
    ground.gestures.setTool(MapTool::Robot);
    ground.pull(ground.screen(3.0, -2.0), ground.screen(3.0 + dx_m, -2.0 + dy_m));
    QVERIFY(ground.content.spawn_draft_in_map && placed.empty()); // It is seen before it is told.
    ground.release(ground.screen(3.0 + dx_m, -2.0 + dy_m));
    QCOMPARE(placed.size(), 1u);
    QVERIFY(!placed[0].first && placed[0].second == ground.content.spawn_draft_in_map);
    QVERIFY((placed[0].second->position_m - Vec3(3.0, -2.0, 0.0)).norm() < 0.06);
    QVERIFY(std::abs(placed[0].second->yaw_rad - yaw_rad) < 0.02);
    QCOMPARE(ground.gestures.tool(), MapTool::Pan); // One robot at a time.
    ground.gestures.setTool(MapTool::Robot);
    ground.press({10, 10});
    ground.release({10, 10});
    QVERIFY(placed.size() == 2 && placed[1].first == placed[0].second);
}

void tst_MapGestures::lineIsMeasuredUntilTheToolIsLeft() {
    Ground ground;
    std::vector<MeasuredLine> told;
    connect(&ground.gestures, &MapGestures::lineMeasured, this,
            [&](const MeasuredLine& line) { told.push_back(line); });
    QSignalSpy panned(&ground.gestures, &MapGestures::panned);
    ground.gestures.setTool(MapTool::Measure);
    ground.pull(ground.screen(1.0, 2.0), ground.screen(4.0, 6.0));
    QVERIFY(ground.content.measured && told.empty()); // It is seen while it is drawn.
    ground.release(ground.screen(4.0, 6.0));
    QCOMPARE(told.size(), std::size_t(1));
    QVERIFY2(std::abs(told[0].length_m() - 5.0) < 0.15, qPrintable(QString::number(told[0].length_m())));
    QVERIFY(ground.content.measured == told[0]);
    QCOMPARE(panned.count(), 0);
    QCOMPARE(ground.gestures.tool(), MapTool::Measure); // For another line.
    ground.press({50, 50});
    ground.release({50, 50});
    QVERIFY2(!ground.content.measured && told.size() == 1, "a click draws no line");
    ground.pull({50, 50}, {90, 90});
    QVERIFY(ground.gestures.escape()); // In the middle
    QVERIFY(!ground.content.measured);
    ground.release({90, 90});
    QCOMPARE(told.size(), std::size_t(1));
    ground.pull({50, 50}, {90, 90});
    ground.release({90, 90});
    QVERIFY(ground.content.measured && ground.gestures.escape());
    QVERIFY(!ground.content.measured);
    QCOMPARE(ground.gestures.tool(), MapTool::Pan);
}

void tst_MapGestures::aRectangleIsMeasuredWithShift() {
    Ground ground;
    ground.gestures.setTool(MapTool::Measure);
    ground.press(ground.screen(1.0, 2.0));
    ground.move(ground.screen(3.0, 3.0));
    QVERIFY(ground.content.measured && !ground.content.measured->spans_rectangle);
    ground.move(ground.screen(4.0, 6.0), Qt::ShiftModifier);
    ground.release(ground.screen(4.0, 6.0), Qt::ShiftModifier);
    QVERIFY(ground.content.measured && ground.content.measured->spans_rectangle);
    QVERIFY(std::abs(ground.content.measured->rectangle_in_map().area_m2() - 12.0) < 1.0);
}

void tst_MapGestures::theWriterIsAskedForOnTheGroundOnly() {
    Ground ground;
    std::vector<Vec2> asked;
    connect(&ground.gestures, &MapGestures::writerAsked, this, [&](const Vec2& at_m) { asked.push_back(at_m); });
    ground.press(ground.screen(3.0, -2.0));
    ground.release(ground.screen(3.0, -2.0)); // Without Ctrl it is a click like any other.
    QVERIFY(asked.empty());
    ground.press(ground.screen(3.0, -2.0));
    ground.release(ground.screen(3.0, -2.0), Qt::ControlModifier);
    QCOMPARE(asked.size(), std::size_t(1));
    QVERIFY((asked[0] - Vec2(3.0, -2.0)).norm() < 0.15);
    ground.content.objects.objects = {crate("crate", {3.0, -2.0})};
    QSignalSpy clicked(&ground.gestures, &MapGestures::objectClicked);
    ground.press(ground.screen(3.0, -2.0));
    ground.release(ground.screen(3.0, -2.0), Qt::ControlModifier);
    QCOMPARE(asked.size(), std::size_t(1)); // The object is in the way.
    QCOMPARE(clicked.size(), 1);
}

void tst_MapGestures::placingIsCanceledAndTakenAway() {
    Ground ground;
    int told = 0;
    connect(&ground.gestures, &MapGestures::draftPlaced, this, [&] { ++told; });
    QVERIFY(!ground.gestures.escape());
    ground.gestures.setTool(MapTool::Robot);
    ground.pull({100, 100}, {150, 100});
    QVERIFY(ground.gestures.escape());
    ground.release({150, 100});
    QVERIFY(!ground.content.spawn_draft_in_map && told == 0);
    QCOMPARE(ground.gestures.tool(), MapTool::Robot); // Another try.
    ground.pull({100, 100}, {150, 100});
    ground.release({150, 100});
    QVERIFY(ground.content.spawn_draft_in_map && told == 1);
    QVERIFY(ground.gestures.escape()); // The next Escape takes the robot away, as an edit.
    QVERIFY(!ground.content.spawn_draft_in_map && told == 2);
    QVERIFY(!ground.gestures.escape());
}

void tst_MapGestures::placedRobotIsClicked() {
    Ground ground;
    QSignalSpy clicked(&ground.gestures, &MapGestures::draftClicked);
    ground.gestures.setDraft(Pose{{3.0, 2.0, 0.0}});
    ground.press(ground.screen(3.5, 2.0));
    ground.release(ground.screen(3.5, 2.0));
    QCOMPARE(clicked.count(), 1);
    ground.press(ground.screen(7.0, 2.0));
    ground.release(ground.screen(7.0, 2.0));
    QCOMPARE(clicked.count(), 1);
    QCOMPARE(ground.content.startOf(SpawnChoice::at_draft), std::optional(Pose{{3.0, 2.0, 0.0}}));
    QVERIFY(!ground.content.startOf(0));
    ground.gestures.setDraft({});
    QVERIFY(!ground.content.startOf(SpawnChoice::at_draft));
}

USAR_TEST(tst_MapGestures)

} // namespace tst_map_gestures

#include "tst_map_gestures.moc"
