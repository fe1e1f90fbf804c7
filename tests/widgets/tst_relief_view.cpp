#include <cmath>

#include <sys/resource.h>

#include <QDir>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include "tests/suite/suite.h"
#include "widgets/map/map_overlay.h"
#include "widgets/relief/relief_view.h"
#include "widgets/style/theme.h"

namespace tst_relief_view {

using namespace usar;
using namespace usar::widgets;

namespace {

/// Hills that are known everywhere in a tile.
std::shared_ptr<const mapping::HeightTile> tileAt(mapping::GridIndex index, float base_m = 0.0f) {
    constexpr std::int32_t side = mapping::HeightTile::side;
    auto tile = std::make_shared<mapping::HeightTile>();
    tile->index = index;
    for (std::size_t i = 0; i < mapping::HeightTile::cell_count; ++i) {
        const double column = double(index.column) * side + double(i % side);
        const double row = double(index.row) * side + double(i / side);
        tile->preview_m[i] = tile->height_m[i] =
            base_m + static_cast<float>(2.0 * std::sin(column / 9.0) * std::cos(row / 7.0));
        tile->hits[i] = 3;
    }
    return tile;
}

constexpr mapping::HeightRange range{-2.0f, 2.0f};

/// A map with a view beside it, as the window has them.
struct Pair {
    MapView map;
    ReliefView view{map};

    Pair() {
        map.heights().clear(0.25);
        map.resize(300, 200);
        view.resize(640, 400);
        view.show();
    }
    ReliefCanvas& canvas() { return view.canvas(); }
    mapping::OrbitCamera camera() { return canvas().camera(); }
    bool drawn() {
        return QTest::qWaitFor(
            [this] { return canvas().frame() && !view.renderer().busy() && canvas().frame()->camera == camera(); });
    }
    void scan(mapping::GridIndex index = {0, 0}) { map.heights().take({tileAt(index)}, range); }
    QPoint middle() { return canvas().rect().center(); }
};

void drag(QWidget& widget, Qt::MouseButton button, Qt::KeyboardModifiers keys, const QPoint& from, const QPoint& to) {
    QTest::mousePress(&widget, button, keys, from);
    QMouseEvent move(QEvent::MouseMove, to, widget.mapToGlobal(to), Qt::NoButton, button, keys);
    QCoreApplication::sendEvent(&widget, &move);
    QTest::mouseRelease(&widget, button, keys, to);
}

std::size_t differentPixels(const ReliefFrame& a, const ReliefFrame& b) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < std::min(a.picture.argb.size(), b.picture.argb.size()); ++i)
        different += a.picture.argb[i] != b.picture.argb[i];
    return different;
}

} // namespace

class tst_ReliefView : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { applyTheme(Theme::Dark); }
    void anEmptyViewSaysWhatWillBeHere();
    void theCameraShowsAllAsTheMapGrows();
    void theMouseMovesTheCamera_data();
    void theMouseMovesTheCamera();
    void panningKeepsTheGroundUnderTheMouse();
    void theWheelZoomsTowardThePointer();
    void keysMoveTheCamera_data();
    void keysMoveTheCamera();
    void aDoubleClickCenters();
    void robotsTrailsAndLayersAreThoseOfTheMap();
    void theSelectedRobotIsFollowed();
    void aFrameFromBeforeATurnDoesNotTurnBack();
    void slowPicturesAreHalfAsLargeWhileTheCameraMoves_data();
    void slowPicturesAreHalfAsLargeWhileTheCameraMoves();
    void keysPanAtAnyElevation_data();
    void keysPanAtAnyElevation();
    void theNewestRequestWins();
    void aReplacedRequestLeavesItsTiles_data();
    void aReplacedRequestLeavesItsTiles();
    void onlyChangedTilesAreHandedOver();
    void itDrawsAfterTheOtherThreads();
    void aHiddenViewDoesNothing();
    void thePointerTellsTheHeight();
    void theMiddleIsReadByKeyboard_data();
    void theMiddleIsReadByKeyboard();
    void aNameStandsAboveTheGround();
    void thePictureHasNamesAndNoFrame();
    void heightsAreExaggerated();
    void theStateComesBack_data();
    void theStateComesBack();
    void nonsenseChangesNothing_data();
    void nonsenseChangesNothing();
    void aThemeRecolorsTheSky();
};

void tst_ReliefView::anEmptyViewSaysWhatWillBeHere() {
    Pair pair;
    QVERIFY(pair.view.emptyState()->isVisible());
    QVERIFY(!pair.view.emptyState()->accessibleName().isEmpty());
    pair.scan();
    QVERIFY(pair.drawn());
    QVERIFY(!pair.view.emptyState()->isVisible());
    pair.map.clear();
    QTRY_VERIFY(pair.view.emptyState()->isVisible());
    QVERIFY(!pair.canvas().frame());
}

void tst_ReliefView::theCameraShowsAllAsTheMapGrows() {
    Pair pair;
    pair.scan();
    QVERIFY(pair.drawn());
    const mapping::OrbitCamera before = pair.camera();
    pair.scan({1, 0});
    QTRY_VERIFY(pair.camera().distance_m > 1.3 * before.distance_m);
    QVERIFY(pair.drawn());
    QVERIFY(pair.camera().target_in_map_m.x() > before.target_in_map_m.x() + 4.0);
    // Once the user has moved it, it stays.
    QTest::keyClick(&pair.canvas(), Qt::Key_Left);
    QVERIFY(pair.drawn());
    const mapping::OrbitCamera chosen = pair.camera();
    const auto frame = pair.canvas().frame();
    pair.scan({2, 0});
    QTRY_VERIFY(differentPixels(*pair.canvas().frame(), *frame) > 1000);
    QCOMPARE(pair.camera(), chosen);
}

void tst_ReliefView::theMouseMovesTheCamera_data() {
    QTest::addColumn<int>("button");
    QTest::addColumn<bool>("shift");
    QTest::addColumn<QPoint>("by");
    QTest::addColumn<double>("yaw"); // signs of the changes
    QTest::addColumn<double>("elevation");
    QTest::addColumn<bool>("moves");
    QTest::newRow("left to the right") << int(Qt::LeftButton) << false << QPoint(40, 0) << -1.0 << 0.0 << false;
    QTest::newRow("left to the left") << int(Qt::LeftButton) << false << QPoint(-40, 0) << 1.0 << 0.0 << false;
    QTest::newRow("left down") << int(Qt::LeftButton) << false << QPoint(0, 40) << 0.0 << 1.0 << false;
    QTest::newRow("left up") << int(Qt::LeftButton) << false << QPoint(0, -40) << 0.0 << -1.0 << false;
    QTest::newRow("shift and left") << int(Qt::LeftButton) << true << QPoint(40, 10) << 0.0 << 0.0 << true;
    QTest::newRow("middle") << int(Qt::MiddleButton) << false << QPoint(40, 10) << 0.0 << 0.0 << true;
    QTest::newRow("right") << int(Qt::RightButton) << false << QPoint(-40, 10) << 0.0 << 0.0 << true;
}

void tst_ReliefView::theMouseMovesTheCamera() {
    QFETCH(int, button);
    QFETCH(bool, shift);
    QFETCH(QPoint, by);
    QFETCH(double, yaw);
    QFETCH(double, elevation);
    QFETCH(bool, moves);
    Pair pair;
    pair.scan();
    QVERIFY(pair.drawn());
    const mapping::OrbitCamera before = pair.camera();
    drag(pair.canvas(), Qt::MouseButton(button), shift ? Qt::ShiftModifier : Qt::NoModifier, pair.middle(),
         pair.middle() + by);
    const mapping::OrbitCamera after = pair.camera();
    const auto sign = [](double value) { return value > 1e-9 ? 1.0 : value < -1e-9 ? -1.0 : 0.0; };
    QCOMPARE(sign(after.yaw_rad - before.yaw_rad), yaw);
    QCOMPARE(sign(after.elevation_rad - before.elevation_rad), elevation);
    QCOMPARE((after.target_in_map_m - before.target_in_map_m).norm() > 0.1, moves);
    QCOMPARE(after.distance_m, before.distance_m);
    QVERIFY(pair.drawn());
}

void tst_ReliefView::panningKeepsTheGroundUnderTheMouse() {
    Pair pair;
    pair.scan();
    QVERIFY(pair.drawn());
    const auto grabbed_m = pair.canvas().pick(pair.middle());
    QVERIFY(grabbed_m);
    const QPoint to = pair.middle() + QPoint(70, 30);
    drag(pair.canvas(), Qt::RightButton, Qt::NoModifier, pair.middle(), to);
    QVERIFY(pair.drawn());
    const auto now_m = pair.canvas().pick(to);
    QVERIFY(now_m);
    QVERIFY((*now_m - *grabbed_m).norm() < 0.5);
}

void tst_ReliefView::theWheelZoomsTowardThePointer() {
    Pair pair;
    pair.scan();
    QVERIFY(pair.drawn());
    const QPoint at = pair.middle() + QPoint(60, 25);
    const auto under_m = pair.canvas().pick(at);
    QVERIFY(under_m);
    const double distance_m = pair.camera().distance_m;
    QWheelEvent closer(at, pair.canvas().mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                       false);
    QCoreApplication::sendEvent(&pair.canvas(), &closer);
    QVERIFY(pair.camera().distance_m < 0.8 * distance_m);
    QVERIFY(pair.drawn());
    const auto now_m = pair.canvas().pick(at);
    QVERIFY(now_m);
    QVERIFY((*now_m - *under_m).norm() < 0.5);
}

void tst_ReliefView::keysMoveTheCamera_data() {
    QTest::addColumn<int>("key");
    QTest::addColumn<bool>("shift");
    QTest::addColumn<QString>("what");
    QTest::newRow("left") << int(Qt::Key_Left) << false << "yaw";
    QTest::newRow("right") << int(Qt::Key_Right) << false << "yaw";
    QTest::newRow("up") << int(Qt::Key_Up) << false << "elevation";
    QTest::newRow("down") << int(Qt::Key_Down) << false << "elevation";
    QTest::newRow("shift and left") << int(Qt::Key_Left) << true << "target";
    QTest::newRow("shift and up") << int(Qt::Key_Up) << true << "target";
    QTest::newRow("plus") << int(Qt::Key_Plus) << false << "distance";
    QTest::newRow("minus") << int(Qt::Key_Minus) << false << "distance";
    QTest::newRow("y up") << int(Qt::Key_N) << false << "yaw";
    QTest::newRow("from above") << int(Qt::Key_T) << false << "elevation";
}

void tst_ReliefView::keysMoveTheCamera() {
    QFETCH(int, key);
    QFETCH(bool, shift);
    QFETCH(QString, what);
    Pair pair;
    pair.scan();
    QVERIFY(pair.drawn());
    const mapping::OrbitCamera before = pair.camera();
    QTest::keyClick(&pair.canvas(), Qt::Key(key), shift ? Qt::ShiftModifier : Qt::NoModifier);
    const mapping::OrbitCamera after = pair.camera();
    QCOMPARE(after.yaw_rad != before.yaw_rad, what == "yaw");
    QCOMPARE(after.elevation_rad != before.elevation_rad, what == "elevation");
    QCOMPARE(after.distance_m != before.distance_m, what == "distance");
    QCOMPARE((after.target_in_map_m - before.target_in_map_m).norm() > 0.01, what == "target");
    QVERIFY(!pair.canvas().showsAll());
    QTest::keyClick(&pair.canvas(), Qt::Key_Home);
    QVERIFY(pair.canvas().showsAll());
    QVERIFY(pair.drawn());
    QTRY_VERIFY((pair.camera().target_in_map_m - before.target_in_map_m).norm() < 0.2 * before.distance_m);
}

void tst_ReliefView::aDoubleClickCenters() {
    Pair pair;
    pair.scan();
    QVERIFY(pair.drawn());
    const QPoint at = pair.middle() + QPoint(-50, 20);
    const auto there_m = pair.canvas().pick(at);
    QVERIFY(there_m);
    QTest::mouseDClick(&pair.canvas(), Qt::LeftButton, {}, at);
    QCOMPARE(pair.camera().target_in_map_m, *there_m);
    QVERIFY(pair.drawn());
    const auto middle_m = pair.canvas().pick(pair.middle());
    QVERIFY(middle_m);
    QVERIFY((*middle_m - *there_m).norm() < 0.5);
}

void tst_ReliefView::robotsTrailsAndLayersAreThoseOfTheMap() {
    Pair pair;
    pair.scan();
    QVERIFY(pair.drawn());
    const auto without = pair.canvas().frame();
    const auto pixels = [&pair](const QColor& color) {
        const auto& argb = pair.canvas().frame()->picture.argb;
        return std::ranges::count(argb, color.rgb());
    };
    QCOMPARE(pixels(robotColor(2)), 0);
    for (int i = 0; i <= 20; ++i)
        pair.map.setRobot({"R2", 2, {{2.0 + 0.5 * i, 8.0, 4.0}, 0.0, 0.0, 0.0}});
    QTRY_VERIFY(pixels(robotColor(2)) > 100); // The solid is shaded, so this is the trail.
    QVERIFY(pair.drawn());
    const auto with_trail = pixels(robotColor(2));
    pair.map.setLayer(MapLayer::Trails, {false, 1.0});
    QTRY_VERIFY(pixels(robotColor(2)) < with_trail / 2); // What is left is the line down to the ground.
    pair.map.setLayer(MapLayer::Robots, {false, 1.0});
    QTRY_COMPARE(differentPixels(*pair.canvas().frame(), *without), std::size_t(0));
    pair.map.setArea(Rectangle{{3, 3}, {10, 9}});
    QTRY_VERIFY(pixels(tokens().accent) > 50);
    pair.map.setLayer(MapLayer::Area, {false, 1.0});
    QTRY_COMPARE(pixels(tokens().accent), 0);
}

void tst_ReliefView::theSelectedRobotIsFollowed() {
    Pair pair;
    pair.scan();
    pair.map.setRobot({"R1", 1, {{3.0, 3.0, 2.0}, 0.0, 0.0, 0.0}});
    pair.map.selectRobot("R1");
    QVERIFY(pair.drawn());
    pair.view.setState({{"follow", true}});
    QTRY_COMPARE(pair.camera().target_in_map_m, Vec3(3, 3, 2));
    pair.map.setRobot({"R1", 1, {{5.0, 3.0, 2.0}, 0.0, 0.0, 0.0}});
    QTRY_COMPARE(pair.camera().target_in_map_m, Vec3(5, 3, 2));
    QVERIFY(pair.drawn());
    const QPoint at = pair.middle() + QPoint(60, 25);
    QWheelEvent closer(at, pair.canvas().mapToGlobal(at), {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                       false);
    QCoreApplication::sendEvent(&pair.canvas(), &closer);
    QCOMPARE(pair.camera().target_in_map_m, Vec3(5, 3, 2)); // The wheel does not leave the robot.
    QVERIFY(pair.view.following());
    pair.map.selectRobot("");
    QTRY_VERIFY(!pair.map.content().selectedRobot());
    QVERIFY(pair.view.following()); // Until there is a robot again.
    pair.map.selectRobot("R1");
    QTest::keyClick(&pair.canvas(), Qt::Key_Left, Qt::ShiftModifier);
    QVERIFY(!pair.view.following()); // Panning ends it.
    pair.view.setState({{"follow", true}, {"target_m", QJsonArray{1, 2, 3}}});
    QTRY_COMPARE(pair.camera().target_in_map_m, Vec3(5, 3, 2));
    QTest::keyClick(&pair.canvas(), Qt::Key_Home);
    QVERIFY(!pair.view.following() && pair.canvas().showsAll());
}

void tst_ReliefView::aFrameFromBeforeATurnDoesNotTurnBack() {
    Pair pair;
    pair.scan();
    QVERIFY(pair.drawn());
    const auto older = std::make_shared<ReliefFrame>(*pair.canvas().frame());
    QVERIFY(older->show_all);
    QTest::keyClick(&pair.canvas(), Qt::Key_Left);
    QTest::keyClick(&pair.canvas(), Qt::Key_Home);
    const double yaw_rad = pair.camera().yaw_rad;
    QVERIFY(yaw_rad != older->camera.yaw_rad);
    pair.canvas().setFrame(older);
    QCOMPARE(pair.camera().yaw_rad, yaw_rad);
    QVERIFY(pair.drawn());
    QCOMPARE(pair.camera().yaw_rad, yaw_rad);
}

void tst_ReliefView::slowPicturesAreHalfAsLargeWhileTheCameraMoves_data() {
    QTest::addColumn<double>("took_ms");
    QTest::addColumn<int>("part");
    QTest::newRow("fast") << 10.0 << 1;
    QTest::newRow("slow") << 60.0 << 2;
}

void tst_ReliefView::slowPicturesAreHalfAsLargeWhileTheCameraMoves() {
    QFETCH(const double, took_ms);
    QFETCH(const int, part);
    Pair pair;
    pair.scan();
    QVERIFY(pair.drawn());
    const QSize whole = pair.canvas().wantedSize_px();
    auto frame = std::make_shared<ReliefFrame>(*pair.canvas().frame());
    frame->took_ms = took_ms;
    pair.canvas().setFrame(frame);
    QTest::keyClick(&pair.canvas(), Qt::Key_Left);
    QCOMPARE(pair.canvas().wantedSize_px(), whole / part);
    QTRY_COMPARE(pair.canvas().wantedSize_px(), whole); // The camera has come to rest.
    QTRY_COMPARE(pair.canvas().frame()->picture.width_px, whole.width());
}

void tst_ReliefView::keysPanAtAnyElevation_data() {
    QTest::addColumn<int>("key");
    for (const int key : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down})
        QTest::addRow("%d", key) << key;
}

void tst_ReliefView::keysPanAtAnyElevation() {
    QFETCH(const int, key);
    Pair pair;
    pair.scan();
    pair.view.setState(
        {{"yaw_deg", 90.0}, {"elevation_deg", 5.0}, {"target_m", QJsonArray{8, 8, 0}}, {"distance_m", 30.0}});
    QTest::keyClick(&pair.canvas(), Qt::Key(key), Qt::ShiftModifier);
    const Vec3 by_m = pair.camera().target_in_map_m - Vec3(8, 8, 0);
    const std::map<int, Vec3> ways{{Qt::Key_Left, -Vec3::UnitX()},
                                   {Qt::Key_Right, Vec3::UnitX()},
                                   {Qt::Key_Up, Vec3::UnitY()},
                                   {Qt::Key_Down, -Vec3::UnitY()}};
    QVERIFY(by_m.norm() > 1.0 && by_m.norm() < 10.0);
    QVERIFY((by_m.normalized() - ways.at(key)).norm() < 1e-9);
}

void tst_ReliefView::theNewestRequestWins() {
    ReliefRenderer renderer;
    std::vector<double> distances_m;
    connect(&renderer, &ReliefRenderer::drawn, this,
            [&](const std::shared_ptr<const ReliefFrame>& frame) { distances_m.push_back(frame->camera.distance_m); });
    ReliefRequest request;
    request.changed[{0, 0}] = tileAt({0, 0});
    request.style.range = range;
    request.size_px = {200, 100};
    for (int i = 1; i <= 50; ++i) {
        request.camera.distance_m = 10.0 * i;
        renderer.draw(request);
    }
    QTRY_VERIFY(!renderer.busy());
    QCOMPARE(distances_m, (std::vector{10.0, 500.0})); // The first was begun, the last waited.
    QCOMPARE(renderer.frameCount(), 2);
}

void tst_ReliefView::aReplacedRequestLeavesItsTiles_data() {
    QTest::addColumn<bool>("cleared"); // by the request that is replaced
    QTest::addColumn<bool>("last_cleared");
    QTest::addColumn<std::vector<bool>>("seen"); // tiles 0, 1 and 2
    QTest::newRow("the map grows") << false << false << std::vector{true, true, true};
    QTest::newRow("it is cleared first") << true << false << std::vector{false, true, true};
    QTest::newRow("it is cleared last") << false << true << std::vector{false, false, true};
}

void tst_ReliefView::aReplacedRequestLeavesItsTiles() {
    QFETCH(bool, cleared);
    QFETCH(bool, last_cleared);
    QFETCH(std::vector<bool>, seen);
    ReliefRenderer renderer;
    std::shared_ptr<const ReliefFrame> frame;
    connect(&renderer, &ReliefRenderer::drawn, this,
            [&](const std::shared_ptr<const ReliefFrame>& drawn) { frame = drawn; });
    ReliefRequest request;
    request.style.range = range;
    request.size_px = {300, 100};
    request.camera.target_in_map_m = {24, 8, 0};
    request.camera.elevation_rad = mapping::OrbitCamera::highest_elevation_rad;
    for (int i = 0; i < 3; ++i) { // The first is begun, the third replaces the second.
        request.changed = {{{i, 0}, tileAt({i, 0})}};
        request.forgets_tiles = (i == 1 && cleared) || (i == 2 && last_cleared);
        renderer.draw(request);
    }
    QTRY_VERIFY(!renderer.busy());
    QCOMPARE(renderer.frameCount(), 2);
    for (int i = 0; i < 3; ++i) {
        const auto at = frame->projection().project({8.0 + 16.0 * i, 8.0, 0.0});
        QCOMPARE(frame->picture.pick(int(at->x_px), int(at->y_px), frame->projection()).has_value(),
                 bool(seen[std::size_t(i)]));
    }
}

/// The renderer keeps the tiles, so one that the view would hand over again is held by one more.
void tst_ReliefView::onlyChangedTilesAreHandedOver() {
    Pair pair;
    pair.scan();
    QVERIFY(pair.drawn());
    QTRY_VERIFY(!pair.map.heights().busy()); // Its worker holds tiles, too.
    const auto heldBy = [&pair] { return pair.map.heights().tiles().at({0, 0}).use_count(); };
    const long before = heldBy();
    int held_more = 0;
    for (int i = 1; i <= 5; ++i) {
        const int frames = pair.view.renderer().frameCount();
        QTest::keyClick(&pair.canvas(), Qt::Key_Left);
        held_more += heldBy() > before;
        QTRY_VERIFY(pair.view.renderer().frameCount() > frames);
    }
    QCOMPARE(held_more, 0);
    QVERIFY(pair.drawn());
    QVERIFY(pair.canvas().pick(pair.middle()));
}

void tst_ReliefView::itDrawsAfterTheOtherThreads() {
    Pair pair;
    pair.scan();
    QVERIFY(pair.drawn());
    int nice_threads = 0;
    for (const QString& task : QDir("/proc/self/task").entryList(QDir::Dirs | QDir::NoDotAndDotDot))
        nice_threads += getpriority(PRIO_PROCESS, task.toUInt()) > getpriority(PRIO_PROCESS, 0);
    QVERIFY(nice_threads >= 1); // The job's own thread waits for the next one.
}

void tst_ReliefView::aHiddenViewDoesNothing() {
    Pair pair;
    pair.scan();
    QVERIFY(pair.drawn());
    pair.view.setUncovered(false);
    const int frames = pair.view.renderer().frameCount();
    QSignalSpy painted(&pair.map.heights(), &HeightLayer::changed);
    pair.scan({1, 0});
    QVERIFY(painted.wait());
    pair.canvas().resize(300, 200);
    QCOMPARE(pair.view.renderer().frameCount(), frames);
    QVERIFY(!pair.view.renderer().busy());
    pair.view.setUncovered(true);
    QTRY_VERIFY(pair.view.renderer().frameCount() > frames);
}

void tst_ReliefView::thePointerTellsTheHeight() {
    Pair pair;
    pair.scan();
    QVERIFY(pair.drawn());
    QSignalSpy pointed(&pair.canvas(), &ReliefCanvas::pointed);
    QMouseEvent move(QEvent::MouseMove, pair.middle(), pair.canvas().mapToGlobal(pair.middle()), Qt::NoButton,
                     Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&pair.canvas(), &move);
    QCOMPARE(pointed.size(), 1);
    const auto point_m = pointed.last()[0].value<std::optional<Vec3>>();
    QVERIFY(point_m && pair.map.heights().probe(point_m->head<2>()));
    QVERIFY(pair.canvas().probe().contains("z "));
}

void tst_ReliefView::theMiddleIsReadByKeyboard_data() {
    QTest::addColumn<QString>("before");
    QTest::addColumn<bool>("read");
    QTest::newRow("without focus") << "" << false;
    QTest::newRow("focused") << "focus" << true;
    QTest::newRow("a key, with the mouse over it") << "mouse key" << true;
    QTest::newRow("the mouse has left") << "focus mouse leave" << true;
    QTest::newRow("the focus has left") << "focus blur" << false;
}

void tst_ReliefView::theMiddleIsReadByKeyboard() {
    QFETCH(QString, before);
    QFETCH(bool, read);
    Pair pair;
    pair.scan();
    pair.view.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&pair.view));
    pair.view.findChild<QComboBox*>()->setFocus();
    QVERIFY(pair.drawn());
    const QPoint corner = pair.middle() + QPoint(-60, 40);
    for (const QString& step : before.split(' ')) {
        if (step == "focus")
            pair.canvas().setFocus();
        else if (step == "blur")
            pair.view.findChild<QComboBox*>()->setFocus();
        else if (step == "leave") {
            QEvent leave(QEvent::Leave);
            QCoreApplication::sendEvent(&pair.canvas(), &leave);
        } else if (step == "key") {
            pair.canvas().setFocus();
            QTest::keyClick(&pair.canvas(), Qt::Key_Right);
        } else if (step == "mouse") {
            QMouseEvent move(QEvent::MouseMove, corner, pair.canvas().mapToGlobal(corner), Qt::NoButton, Qt::NoButton,
                             Qt::NoModifier);
            QCoreApplication::sendEvent(&pair.canvas(), &move);
        }
    }
    QVERIFY(pair.drawn());
    if (!read) {
        QVERIFY(pair.canvas().probe().isEmpty());
        return;
    }
    const auto middle_m = pair.canvas().pick(QRectF(pair.canvas().rect()).center());
    QVERIFY(middle_m);
    const Vec2 at_m = middle_m->head<2>();
    QCOMPARE(pair.canvas().probe(), probeText(at_m, pair.map.heights().probe(at_m)));
    QTest::keyClick(&pair.canvas(), Qt::Key_Up, Qt::ShiftModifier);
    QVERIFY(pair.drawn());
    QVERIFY(pair.canvas().probe() != probeText(at_m, pair.map.heights().probe(at_m)));
}

void tst_ReliefView::aNameStandsAboveTheGround() {
    Pair pair;
    pair.scan();
    for (const double z_m : {-20.0, 5.0}) {
        pair.map.setRobot({"R1", 1, {{8.0, 8.0, z_m}, 0.0, 0.0, 0.0}});
        const double wanted_m = std::max(z_m, double(pair.map.heights().probe({8.0, 8.0})->height_m));
        QTRY_VERIFY(!pair.canvas().labels().empty() && pair.canvas().labels()[0].place_in_map_m.z() == wanted_m);
    }
}

void tst_ReliefView::thePictureHasNamesAndNoFrame() {
    Pair pair;
    QVERIFY(pair.canvas().picture().isNull());
    pair.scan();
    QVERIFY(pair.drawn());
    pair.canvas().setFocus();
    const auto differs = [&pair] {
        const QImage picture = pair.canvas().picture();
        const mapping::ReliefPicture& drawn = pair.canvas().frame()->picture;
        int different = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                different += picture.pixel(x, y) != drawn.argb[drawn.indexOf(x, y)];
        return different;
    };
    QCOMPARE(pair.canvas().picture().size(), pair.canvas().wantedSize_px());
    const int axes = differs();
    QVERIFY(axes > 1000);
    QCOMPARE(pair.canvas().picture().pixel(0, 0), pair.canvas().frame()->picture.argb.front()); // No ring of the focus.
    pair.canvas().setLabels({{"R1", pair.camera().target_in_map_m}});
    QVERIFY(differs() > axes + 100);
}

void tst_ReliefView::heightsAreExaggerated() {
    Pair pair;
    pair.scan();
    QVERIFY(pair.drawn());
    const auto before = pair.canvas().frame();
    auto* const box = pair.view.findChild<QComboBox*>();
    box->setCurrentIndex(box->count() - 1);
    QTRY_COMPARE(pair.canvas().frame()->exaggeration, 5.0);
    QVERIFY(differentPixels(*before, *pair.canvas().frame()) > 1000);
}

void tst_ReliefView::theStateComesBack_data() {
    QTest::addColumn<QJsonObject>("state");
    QTest::addColumn<bool>("shows_all");
    QTest::newRow("nothing") << QJsonObject{} << true;
    QTest::newRow("direction only") << QJsonObject{{"yaw_deg", 20.0}, {"elevation_deg", 50.0}} << true;
    QTest::newRow("a place") << QJsonObject{{"yaw_deg", 20.0},
                                            {"elevation_deg", 50.0},
                                            {"target_m", QJsonArray{1.0, 2.0, 3.0}},
                                            {"distance_m", 30.0},
                                            {"exaggeration", 3.0}}
                             << false;
    QTest::newRow("following") << QJsonObject{{"follow", true}} << true;
    QTest::newRow("nonsense") << QJsonObject{{"yaw_deg", "x"}, {"target_m", 5}, {"exaggeration", 77.0}} << true;
}

void tst_ReliefView::theStateComesBack() {
    QFETCH(QJsonObject, state);
    QFETCH(bool, shows_all);
    Pair pair;
    pair.view.setState(state);
    QCOMPARE(pair.canvas().showsAll(), shows_all);
    if (state["elevation_deg"].isDouble()) {
        QVERIFY(std::abs(degrees(pair.camera().yaw_rad) - 20.0) < 1e-9);
        QVERIFY(std::abs(degrees(pair.camera().elevation_rad) - 50.0) < 1e-9);
    }
    if (!shows_all) {
        QCOMPARE(pair.camera().target_in_map_m, Vec3(1, 2, 3));
        QCOMPARE(pair.camera().distance_m, 30.0);
        QCOMPARE(pair.canvas().exaggeration(), 3.0);
    }
    Pair other;
    other.view.setState(pair.view.state());
    QCOMPARE(other.view.state(), pair.view.state());
}

void tst_ReliefView::nonsenseChangesNothing_data() {
    QTest::addColumn<QJsonObject>("state");
    const QJsonObject nonsense{{"yaw_deg", "x"},      {"elevation_deg", true}, {"target_m", QJsonArray{1, "y", 3}},
                               {"distance_m", "far"}, {"exaggeration", 77.0},  {"follow", "R1"}};
    for (auto value = nonsense.begin(); value != nonsense.end(); ++value)
        QTest::addRow("%s", qPrintable(value.key()))
            << QJsonObject{{"target_m", QJsonArray{1.0, 2.0, 3.0}}, {value.key(), value.value()}};
}

void tst_ReliefView::nonsenseChangesNothing() {
    QFETCH(QJsonObject, state);
    Pair pair;
    pair.view.setState({{"yaw_deg", 20.0},
                        {"elevation_deg", 50.0},
                        {"target_m", QJsonArray{1.0, 2.0, 3.0}},
                        {"distance_m", 30.0},
                        {"exaggeration", 3.0},
                        {"follow", true}});
    const QJsonObject before = pair.view.state();
    pair.view.setState(state);
    QCOMPARE(pair.view.state(), before);
}

void tst_ReliefView::aThemeRecolorsTheSky() {
    Pair pair;
    pair.scan();
    QVERIFY(pair.drawn());
    const auto dark = pair.canvas().frame()->picture.argb[0];
    applyTheme(Theme::Light);
    QTRY_VERIFY(pair.canvas().frame()->picture.argb[0] != dark);
    applyTheme(Theme::Dark);
}

USAR_TEST(tst_ReliefView)

} // namespace tst_relief_view

#include "tst_relief_view.moc"
