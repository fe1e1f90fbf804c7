#include <algorithm>
#include <cmath>
#include <vector>

#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "core/mapping/height_map.h"
#include "tests/suite/suite.h"
#include "widgets/map/map_labels.h"
#include "widgets/map/map_overlay.h"
#include "widgets/map/map_view.h"
#include "widgets/models/figures.h"
#include "widgets/style/theme.h"

namespace tst_map_view {

using namespace usar;
using namespace usar::widgets;

namespace {

const Rectangle world{Vec2(-50, -50), Vec2(50, 50)};

QPoint screen(const MapView& view, double x, double y) {
    return view.transform().toScreen(Vec2(x, y)).toPoint();
}

void drag(QWidget& view, QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mousePress(&view, button, {}, from);
    QTest::mouseMove(&view, from + (to - from) / 2);
    QTest::mouseMove(&view, to);
    QTest::mouseRelease(&view, button, {}, to);
}

void wheel(QWidget& view, QPoint at, int delta) {
    QWheelEvent event(at, view.mapToGlobal(at), {}, {0, delta}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view, &event);
}

} // namespace

class tst_MapView : public QObject {
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void emptyMapSaysWhatWillAppear();
    void doubleClickOnAStartPoseSpawns();
    void oneClickOnAStartPoseAsks();
    void startPosesAreReachedByKeys();
    void dragPansAndClickDoesNot();
    void arrowKeysPan_data();
    void arrowKeysPan();
    void wheelZoomsAtTheCursor();
    void areaToolDrawsAnArea();
    void areaStaysInTheWorld();
    void handleResizesAndMiddleMoves();
    void escapeGivesADragUp();
    void clickOnARobotSelectsIt();
    void followKeepsTheRobotInTheMiddleUntilPanned();
    void robotOnAStartPoseCoversNoName();
    void crowdedStartPoseGivesItsNameUp();
    void theAxesLieInTheirGlass();
    void namesStayWholeAtTheEdge();
    void areaWithoutGroundIsRefused_data();
    void areaWithoutGroundIsRefused();
    void hoverProbesTheGround();
    void probeIsWorded_data();
    void probeIsWorded();
    void fitShowsTheMissionBeforeTheWorld();
    void layersCanBeHidden();
    void thinWorldKeepsItsFrame();
    void resizingKeepsTheWorldInViewUntilTouched();
    void marksOfOtherRobotsAreDimmed();
    void areasOfOtherRobotsAreShown();
    void theProbeTellsWhoScannedAPlace();
    void clearForgetsAllButTheLayers();
    void clearDuringADragBringsNoAreaBack();

private:
    std::unique_ptr<MapView> view_;
};

void tst_MapView::init() {
    view_ = std::make_unique<MapView>();
    view_->resize(800, 600);
    view_->setWorld(world, QStringLiteral("tall_test"));
    view_->setStartPoses({{"PlayerStart", {{0, 0, 0}, 0, 0, 0}}, {"HillTop", {{20, 30, 0}, 0, 0, 1}}});
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
}

void tst_MapView::cleanup() {
    view_.reset();
}

void tst_MapView::emptyMapSaysWhatWillAppear() {
    QVERIFY(view_->findChild<QWidget*>(QStringLiteral("emptyState"))->isHidden());
    view_->clear();
    auto* sheet = view_->findChild<QWidget*>(QStringLiteral("emptyState"));
    QVERIFY(sheet->isVisible());
    QVERIFY(!sheet->accessibleName().isEmpty() && !sheet->accessibleDescription().isEmpty());
    view_->setStartPoses({{"Only", {}}});
    QVERIFY(sheet->isHidden());
}

void tst_MapView::doubleClickOnAStartPoseSpawns() {
    QSignalSpy spawned(view_.get(), &MapView::spawnRequested);
    QTest::mouseDClick(view_.get(), Qt::LeftButton, {}, screen(*view_, 20, 30) + QPoint(4, -3));
    QCOMPARE(spawned.count(), 1);
    QCOMPARE(spawned[0][0].toInt(), 1);
    QTest::mouseDClick(view_.get(), Qt::LeftButton, {}, screen(*view_, -20, 30));
    QCOMPARE(spawned.count(), 1);
}

void tst_MapView::oneClickOnAStartPoseAsks() {
    QSignalSpy asked(view_.get(), &MapView::startPoseClicked);
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, screen(*view_, 0, 0));
    QCOMPARE(asked.count(), 1);
    QCOMPARE(asked[0][0].toInt(), 0);
    const QPoint at = view_->mapFromGlobal(asked[0][1].toPoint());
    QVERIFY2((at - screen(*view_, 0, 0)).manhattanLength() > 20, "the card must not lie under the second click");
    // Qt Test sends the second press of a double-click only; its release must not ask again.
    QTest::mouseDClick(view_.get(), Qt::LeftButton, {}, screen(*view_, 0, 0));
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, screen(*view_, 0, 0));
    QCOMPARE(asked.count(), 1);
}

void tst_MapView::startPosesAreReachedByKeys() {
    QSignalSpy spawned(view_.get(), &MapView::spawnRequested);
    QSignalSpy asked(view_.get(), &MapView::startPoseClicked);
    QTest::keyClick(view_.get(), Qt::Key_Return);
    QCOMPARE(spawned.count(), 0);
    QTest::keyClick(view_.get(), Qt::Key_N);
    QTest::keyClick(view_.get(), Qt::Key_N);
    QTest::keyClick(view_.get(), Qt::Key_Return);
    QCOMPARE(spawned.last()[0].toInt(), 1);
    QTest::keyClick(view_.get(), Qt::Key_N, Qt::ShiftModifier);
    QTest::keyClick(view_.get(), Qt::Key_Space);
    QCOMPARE(asked.last()[0].toInt(), 0);
}

void tst_MapView::dragPansAndClickDoesNot() {
    const QPointF before = view_->transform().toScreen(Vec2(0, 0));
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, QPoint(100, 100));
    QCOMPARE(view_->transform().toScreen(Vec2(0, 0)), before);
    drag(*view_, QPoint(100, 100), QPoint(160, 80));
    QVERIFY((view_->transform().toScreen(Vec2(0, 0)) - before - QPointF(60, -20)).manhattanLength() < 1e-6);
    drag(*view_, QPoint(160, 80), QPoint(100, 100), Qt::MiddleButton);
    QVERIFY((view_->transform().toScreen(Vec2(0, 0)) - before).manhattanLength() < 1e-6);
}

void tst_MapView::arrowKeysPan_data() {
    QTest::addColumn<Qt::Key>("key");
    QTest::addColumn<QPointF>("ground_goes");
    QTest::newRow("left shows what is left") << Qt::Key_Left << QPointF(64, 0);
    QTest::newRow("right") << Qt::Key_Right << QPointF(-64, 0);
    QTest::newRow("up") << Qt::Key_Up << QPointF(0, 64);
    QTest::newRow("down") << Qt::Key_Down << QPointF(0, -64);
}

void tst_MapView::arrowKeysPan() {
    QFETCH(Qt::Key, key);
    QFETCH(QPointF, ground_goes);
    const QPointF before = view_->transform().toScreen(Vec2(0, 0));
    QTest::keyClick(view_.get(), key);
    QVERIFY((view_->transform().toScreen(Vec2(0, 0)) - before - ground_goes).manhattanLength() < 1e-6);
}

void tst_MapView::wheelZoomsAtTheCursor() {
    const QPoint cursor(600, 150);
    const Vec2 ground = view_->transform().toMap(cursor);
    const double scale = view_->transform().pixels_per_m;
    wheel(*view_, cursor, 240);
    QVERIFY(view_->transform().pixels_per_m > 1.4 * scale);
    QVERIFY((view_->transform().toMap(cursor) - ground).norm() < 1e-9);
    wheel(*view_, cursor, -240);
    QVERIFY(qAbs(view_->transform().pixels_per_m - scale) < 1e-9);
}

void tst_MapView::areaToolDrawsAnArea() {
    QSignalSpy edited(&view_->gestures(), &MapGestures::areaEdited);
    QSignalSpy changed(&view_->gestures(), &MapGestures::areaChanged);
    view_->setTool(MapTool::Area);
    drag(*view_, screen(*view_, 10, 20), screen(*view_, -30, -20));
    QCOMPARE(changed.count(), 1);
    QVERIFY(edited.count() >= 1);
    const auto area = changed[0][0].value<Rectangle>();
    QVERIFY((area.min_m - Vec2(-30, -20)).norm() < 0.8 && (area.max_m - Vec2(10, 20)).norm() < 0.8);
    QCOMPARE(view_->area(), std::optional(area));
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, screen(*view_, 40, 40));
    QCOMPARE(view_->area(), std::optional(area)); // a click draws nothing
}

void tst_MapView::areaStaysInTheWorld() {
    view_->setTool(MapTool::Area);
    drag(*view_, screen(*view_, 0, 0), QPoint(1, 1));
    QVERIFY(view_->area() && world.contains(*view_->area()));
}

void tst_MapView::handleResizesAndMiddleMoves() {
    view_->setTool(MapTool::Area);
    view_->setArea(Rectangle{Vec2(-20, -20), Vec2(20, 20)});
    drag(*view_, screen(*view_, 20, 20), screen(*view_, 30, 25));
    QVERIFY((view_->area()->max_m - Vec2(30, 25)).norm() < 0.8);
    QCOMPARE(view_->area()->min_m, Vec2(-20, -20));
    drag(*view_, screen(*view_, 0, 10), screen(*view_, 0, 5));
    QVERIFY(qAbs(view_->area()->min_m.y() + 25) < 0.8);
    QVERIFY(qAbs(view_->area()->height_m() - 45) < 0.8);
}

void tst_MapView::escapeGivesADragUp() {
    const Rectangle before{Vec2(-20, -20), Vec2(20, 20)};
    QSignalSpy changed(&view_->gestures(), &MapGestures::areaChanged);
    view_->setArea(before);
    view_->setTool(MapTool::Area);
    QTest::mousePress(view_.get(), Qt::LeftButton, {}, screen(*view_, 20, 20));
    QTest::mouseMove(view_.get(), screen(*view_, 35, 35));
    QVERIFY(view_->area() != std::optional(before));
    QTest::keyClick(view_.get(), Qt::Key_Escape);
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, screen(*view_, 35, 35));
    QCOMPARE(view_->area(), std::optional(before));
    QCOMPARE(changed.count(), 0);
}

void tst_MapView::clickOnARobotSelectsIt() {
    QSignalSpy clicked(&view_->gestures(), &MapGestures::robotClicked);
    view_->setRobot({QStringLiteral("R2"), 2, {{-10, 10, 6}, 0, 0, 0}});
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, screen(*view_, -10, 10));
    QCOMPARE(clicked.count(), 1);
    QCOMPARE(clicked[0][0].toString(), QStringLiteral("R2"));
    QCOMPARE(view_->content().selected_robot, QStringLiteral("R2"));
}

void tst_MapView::followKeepsTheRobotInTheMiddleUntilPanned() {
    QSignalSpy following(view_.get(), &MapView::followingChanged);
    view_->setFollowing(true);
    QVERIFY2(!view_->following(), "nobody is selected");
    view_->setRobot({QStringLiteral("R1"), 1, {{5, 5, 6}, 0, 0, 0}});
    view_->selectRobot(QStringLiteral("R1"));
    view_->setFollowing(true);
    view_->setRobot({QStringLiteral("R1"), 1, {{12, -7, 6}, 0, 0, 0}});
    QCOMPARE(view_->transform().center_m, Vec2(12, -7));
    QTest::keyClick(view_.get(), Qt::Key_Left);
    QVERIFY(!view_->following());
    QCOMPARE(following.count(), 2);
}

void tst_MapView::robotOnAStartPoseCoversNoName() {
    for (const double yaw_rad : {0.0, 1.57, 3.1, -1.57})
        for (const bool selected : {true, false}) {
            view_->setRobot({QStringLiteral("R1"), 1, {{0, 0, 0}, 0, 0, yaw_rad}});
            view_->setStartPoses({{"PlayerStart", {{0, 0, 0}, 0, 0, yaw_rad}}});
            view_->selectRobot(selected ? QStringLiteral("R1") : QString());
            const MapLabels labels = placeMapLabels(view_->content(), view_->transform());
            const QRectF robot = labels.robots.at(QStringLiteral("R1"));
            QVERIFY(labels.start_poses[0]);
            QVERIFY(!robot.intersects(*labels.start_poses[0]));
            const QPointF at = view_->transform().toScreen(Vec2(0, 0));
            QVERIFY(!labels.start_poses[0]->contains(at) && !robot.contains(at));
        }
}

void tst_MapView::crowdedStartPoseGivesItsNameUp() {
    view_->setStartPoses({{"PlayerStart", {{0, 0, 0}, 0, 0, 0}}});
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            view_->setRobot({QStringLiteral("R%1%2").arg(x).arg(y), 1, {{5.0 * x, 5.0 * y, 0}, 0, 0, 0}});
    MapLabels labels = placeMapLabels(view_->content(), view_->transform());
    QCOMPARE(labels.robots.size(), std::size_t(9));
    QVERIFY(!labels.start_poses[0]);
    view_->setLayer(MapLayer::Robots, {false, 1.0});
    labels = placeMapLabels(view_->content(), view_->transform());
    QVERIFY2(labels.robots.empty() && labels.start_poses[0], "a hidden robot takes no room");
}

void tst_MapView::theAxesLieInTheirGlass() {
    const QRectF glass = axesGlass_px(view_->transform());
    QVERIFY(QRectF(view_->rect()).contains(glass));
    const QImage image = view_->grab().toImage();
    const QRgb inks[] = {tokens().text.rgb(), tokens().text_muted.rgb()};
    int inside = 0;
    for (int y = 4; y < 150; ++y) // The frame of the focus is left out.
        for (int x = image.width() - 150; x < image.width() - 4; ++x)
            if (const QRgb pixel = image.pixel(x, y); pixel == inks[0] || pixel == inks[1]) {
                const QPointF from_middle = QPointF(x, y) - glass.center();
                QVERIFY2(std::hypot(from_middle.x(), from_middle.y()) < glass.width() / 2.0,
                         qPrintable(QStringLiteral("%1, %2").arg(x).arg(y)));
                ++inside;
            }
    QVERIFY(inside > 40);
}

void tst_MapView::namesStayWholeAtTheEdge() {
    const QPointF corners_px[] = {{6, 300}, {794, 300}, {400, 590}, {400, 6}, {690, 60}};
    std::vector<protocol::StartPose> poses;
    for (const QPointF& corner : corners_px) {
        const Vec2 at = view_->transform().toMap(corner);
        poses.push_back({"SomewhereAtTheEdge", {{at.x(), at.y(), 0}, 0, 0, 0}});
    }
    view_->setStartPoses(poses);
    for (const auto& box : placeMapLabels(view_->content(), view_->transform()).start_poses) {
        QVERIFY(box);
        QVERIFY(QRectF(view_->rect()).contains(*box));
        QVERIFY(!box->intersects(axesGlass_px(view_->transform())));
    }
}

void tst_MapView::areaWithoutGroundIsRefused_data() {
    QTest::addColumn<QPointF>("from_m");
    QTest::addColumn<QPointF>("to_m");
    QTest::addColumn<QString>("words");
    QTest::newRow("left of the world") << QPointF(-60, -10) << QPointF(-52, 10) << QStringLiteral("outside the world");
    QTest::newRow("beyond a corner") << QPointF(52, 52) << QPointF(60, 60) << QStringLiteral("outside the world");
    QTest::newRow("a line") << QPointF(0, 10) << QPointF(20, 10) << QStringLiteral("no size");
}

void tst_MapView::areaWithoutGroundIsRefused() {
    QFETCH(QPointF, from_m);
    QFETCH(QPointF, to_m);
    QFETCH(QString, words);
    const Rectangle before{Vec2(-40, -40), Vec2(-30, -30)};
    view_->setTransform({{}, Vec2::Zero(), 4.0, {}});
    view_->setArea(before);
    view_->setTool(MapTool::Area);
    QSignalSpy refused(&view_->gestures(), &MapGestures::areaRefused);
    QSignalSpy changed(&view_->gestures(), &MapGestures::areaChanged);
    drag(*view_, screen(*view_, from_m.x(), from_m.y()), screen(*view_, to_m.x(), to_m.y()));
    QCOMPARE(refused.count(), 1);
    QVERIFY2(refused[0][0].toString().contains(words), qPrintable(refused[0][0].toString()));
    QCOMPARE(changed.count(), 0);
    QCOMPARE(*view_->area(), before);
    QCOMPARE(view_->tool(), MapTool::Area);
}

void tst_MapView::hoverProbesTheGround() {
    mapping::HeightMap map(0.25);
    map.write(map.cellAt(Vec2(10.1, -5.1)), 4.31f, {1});
    view_->heights().take(map.takeChangedTiles(), map.range());
    view_->setTransform({{}, Vec2(10.1, -5.1), 100.0, {}});
    QTRY_VERIFY(!view_->heights().busy());
    const auto probe = view_->heights().probe(Vec2(10.1, -5.1));
    QVERIFY(probe && probe->height_m == 4.31f && probe->hits == 1);
    QTest::mouseMove(view_.get(), QPoint(20, 20));
    const QImage elsewhere = view_->grab().toImage();
    QTest::mouseMove(view_.get(), screen(*view_, 10.1, -5.1));
    QVERIFY2(view_->grab().toImage() != elsewhere, "the overlay says what is under the cursor");
}

void tst_MapView::probeIsWorded_data() {
    QTest::addColumn<QPointF>("at_m");
    QTest::addColumn<bool>("known");
    QTest::addColumn<QStringList>("figures");
    QTest::newRow("known ground") << QPointF(10.12, -5.1) << true
                                  << QStringList{figure(10.1, 1), figure(-5.1, 1), figure(4.31, 2),
                                                 QStringLiteral("7")};
    QTest::newRow("unknown ground") << QPointF(3.0, 4.0) << false << QStringList{figure(3.0, 1), figure(4.0, 1)};
}

void tst_MapView::probeIsWorded() {
    QFETCH(QPointF, at_m);
    QFETCH(bool, known);
    QFETCH(QStringList, figures);
    const auto ground = known ? std::optional(mapping::HeightProbe{4.31f, 7}) : std::nullopt;
    const QString text = probeText(Vec2(at_m.x(), at_m.y()), ground);
    for (const QString& part : figures + QStringList{"x ", "y ", "z ", " m", "hits "})
        QVERIFY2(text.contains(part), qPrintable(text));
    QCOMPARE(text.contains(QStringLiteral("4.31")), known);
}

void tst_MapView::fitShowsTheMissionBeforeTheWorld() {
    const double whole = view_->transform().pixels_per_m;
    view_->setArea(Rectangle{Vec2(10, 10), Vec2(20, 20)});
    view_->fit();
    QVERIFY(QRectF(view_->rect()).contains(view_->transform().toScreen(Rectangle{Vec2(10, 10), Vec2(20, 20)})));
    QVERIFY(view_->transform().pixels_per_m > 3.0 * whole);
    view_->fitWorld();
    QCOMPARE(view_->transform().pixels_per_m, whole);
}

void tst_MapView::layersCanBeHidden() {
    view_->setRobot({QStringLiteral("R1"), 1, {{-10, -10, 6}, 0, 0, 0}});
    const QPoint at = screen(*view_, -10, -10);
    const auto color = [&] { return view_->grab().toImage().pixelColor(at); };
    QCOMPARE(color(), robotColor(1));
    view_->setLayer(MapLayer::Robots, {false, 1.0});
    QVERIFY(color() != robotColor(1));
    view_->setLayer(MapLayer::Robots, {true, 0.5});
    const QColor half = color();
    QVERIFY(half != robotColor(1) && half.blue() > tokens().ground.blue() + 40);
}

void tst_MapView::thinWorldKeepsItsFrame() {
    view_->setLayer(MapLayer::World, {true, 0.1});
    view_->setLayer(MapLayer::Grid, {false, 1.0});
    const QPointF edge = view_->transform().toScreen(world).bottomLeft();
    const QImage picture = view_->grab().toImage();
    QColor brightest = tokens().background;
    for (int dx = -2; dx <= 2; ++dx)
        if (const QColor c = picture.pixelColor(edge.toPoint() + QPoint(dx, -100)); c.value() > brightest.value())
            brightest = c;
    QVERIFY(contrast(brightest, tokens().background) > 4.0);
}

void tst_MapView::resizingKeepsTheWorldInViewUntilTouched() {
    view_->resize(500, 700);
    QVERIFY(QRectF(view_->rect()).contains(view_->transform().toScreen(world)));
    QTest::keyClick(view_.get(), Qt::Key_Plus);
    const double scale = view_->transform().pixels_per_m;
    view_->resize(800, 700);
    QCOMPARE(view_->transform().pixels_per_m, scale);
}

void tst_MapView::marksOfOtherRobotsAreDimmed() {
    view_->setLayer(MapLayer::World, {false, 1.0});
    view_->setLayer(MapLayer::Grid, {false, 1.0});
    view_->addMarks(QStringLiteral("R1"), {{agent::MarkKind::Recharge, Vec3(-20, 20, 0), Seconds(1), {1}}});
    view_->addMarks(QStringLiteral("R2"), {{agent::MarkKind::Recharge, Vec3(20, 20, 0), Seconds(1), {1}}});
    const auto contrastAt = [&](double x_m) {
        return contrast(view_->grab().toImage().pixelColor(screen(*view_, x_m, 20)), tokens().background);
    };
    QCOMPARE(contrastAt(-20), contrastAt(20)); // Nobody is selected.
    view_->selectRobot(QStringLiteral("R1"));
    QVERIFY(contrastAt(20) > 1.1 && contrastAt(20) < 0.8 * contrastAt(-20));
    view_->selectRobot(QStringLiteral("R2"));
    QVERIFY(contrastAt(-20) > 1.1 && contrastAt(-20) < 0.8 * contrastAt(20));
    view_->clearMarks(QStringLiteral("R2"));
    QVERIFY(contrastAt(20) < 1.05 && contrastAt(-20) > 1.1);
}

void tst_MapView::areasOfOtherRobotsAreShown() {
    view_->setRobot({QStringLiteral("R1"), 1, {{-40, -40, 0}, 0, 0, 0}});
    view_->setRobot({QStringLiteral("R2"), 2, {{-40, 40, 0}, 0, 0, 0}});
    view_->selectRobot(QStringLiteral("R2"));
    const QImage without = view_->grab().toImage();
    view_->setRobotArea(QStringLiteral("R2"), {Vec2(-10, -10), Vec2(30, 30)});
    QCOMPARE(view_->grab().toImage(), without); // That of the selected robot is set by setArea.
    view_->selectRobot(QStringLiteral("R1"));
    const QImage with = view_->grab().toImage();
    const QRect edge = QRectF(view_->transform().toScreen(Rectangle{Vec2(-10, -10), Vec2(30, 30)})).toRect();
    int other = 0;
    for (int x = edge.left(); x < edge.right(); ++x)
        other += with.pixel(x, edge.bottom()) != without.pixel(x, edge.bottom()) ||
                 with.pixel(x, edge.bottom() + 1) != without.pixel(x, edge.bottom() + 1);
    QVERIFY2(other > edge.width() / 3, qPrintable(QString::number(other)));
    view_->removeRobot(QStringLiteral("R2"));
    QVERIFY(!view_->content().robots.contains(QStringLiteral("R2")));
    view_->setRobotArea(QStringLiteral("R2"), {Vec2(-10, -10), Vec2(30, 30)});
    QVERIFY2(!view_->content().robots.contains(QStringLiteral("R2")), "an area makes no robot");
}

void tst_MapView::theProbeTellsWhoScannedAPlace() {
    QVERIFY(probeText({1.0, 2.0}, mapping::HeightProbe{4.31f, 7}, {"R1", "R2"}).endsWith("by R1, R2"));
    QVERIFY(!probeText({1.0, 2.0}, mapping::HeightProbe{4.31f, 7}).contains("by"));
    QVERIFY(!probeText({1.0, 2.0}, mapping::HeightProbe{4.31f, 7}).contains("ago"));
    QVERIFY(probeText({1.0, 2.0}, mapping::HeightProbe{4.31f, 7}, {"R1"}, Seconds(12)).endsWith("12 s ago   by R1"));
    int asked = 0;
    view_->setScannedBy([&](const Vec2& point_m) {
        asked += (point_m - Vec2(10, -5)).norm() < 1.0;
        return QStringList("R1");
    });
    QTest::mouseMove(view_.get(), screen(*view_, 10, -5));
    view_->setRobot({QStringLiteral("R1"), 1, {}});
    (void)view_->grab();
    QCOMPARE(asked, 0); // There is nobody else.
    view_->setRobot({QStringLiteral("R2"), 2, {}});
    (void)view_->grab();
    QVERIFY(asked > 0);
    int asked_for_age = 0;
    view_->setAgeOf([&](const Vec2&) { return ++asked_for_age, std::optional(Seconds(3)); });
    (void)view_->grab();
    QVERIFY(asked_for_age > 0);
}

void tst_MapView::clearForgetsAllButTheLayers() {
    view_->setLayer(MapLayer::Grid, {false, 0.3});
    view_->setRobot({QStringLiteral("R1"), 1, {}});
    view_->addMarks(QStringLiteral("R1"), {{agent::MarkKind::Landing, Vec3::Zero(), Seconds(1), {1}}});
    view_->setArea(Rectangle{Vec2(10, 10), Vec2(20, 20)});
    view_->clear();
    QVERIFY(view_->content().robots.empty() && view_->content().marks.empty() && !view_->area());
    QCOMPARE(view_->layer(MapLayer::Grid), (LayerState{false, 0.3}));
}

void tst_MapView::clearDuringADragBringsNoAreaBack() {
    view_->setArea(Rectangle{Vec2(-20, -20), Vec2(20, 20)});
    view_->setTool(MapTool::Area);
    QTest::mousePress(view_.get(), Qt::LeftButton, {}, screen(*view_, 20, 20));
    QTest::mouseMove(view_.get(), screen(*view_, 35, 35));
    QSignalSpy edited(&view_->gestures(), &MapGestures::areaEdited);
    QSignalSpy changed(&view_->gestures(), &MapGestures::areaChanged);
    view_->clear();
    QTest::mouseMove(view_.get(), QPoint(30, 30));
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, QPoint(30, 30));
    QVERIFY(!view_->area());
    QCOMPARE(edited.count() + changed.count(), 0);
    QCOMPARE(view_->tool(), MapTool::Area);
}

USAR_TEST(tst_MapView)

} // namespace tst_map_view

#include "tst_map_view.moc"
