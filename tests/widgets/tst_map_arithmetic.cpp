#include <algorithm>
#include <cmath>

#include <QTest>

#include "tests/suite/suite.h"
#include "widgets/map/map_labels.h"
#include "widgets/models/map/area_grip.h"
#include "widgets/models/map/map_transform.h"
#include "widgets/models/map/trail.h"

namespace tst_map_arithmetic {

using namespace usar;
using namespace usar::widgets;

class tst_MapArithmetic : public QObject {
    Q_OBJECT
private slots:
    void axesPointWhereTheyShould_data();
    void axesPointWhereTheyShould();
    void screenAndMapAreInverse_data();
    void screenAndMapAreInverse();
    void zoomKeepsTheGroundUnderTheCursor();
    void zoomStaysWithinLimits();
    void panMovesTheGroundWithTheHand();
    void fitShowsAllOfIt_data();
    void fitShowsAllOfIt();
    void fitIgnoresNothing();
    void stepsAreRound_data();
    void stepsAreRound();
    void gripsAreFound_data();
    void gripsAreFound();
    void cornerDragResizes();
    void dragBeyondTheOtherSideSwaps();
    void middleDragMovesAndStaysInTheWorld();
    void spanSnapsAndStaysInTheWorld();
    void namesMoveAside_data();
    void namesMoveAside();
    void nameWithoutRoomIsLeftOutUnlessItMustShow();
    void earlierNamesWin();
    void straightTrailCostsTwoPoints();
    void trailKeepsBends();
    void trailKeepsClimbs();
    void trailIgnoresNonsense();
    void trailIsInterruptedWherePosesAreMissing();
};

void tst_MapArithmetic::axesPointWhereTheyShould_data() {
    QTest::addColumn<MapOrientation>("orientation");
    QTest::addColumn<QPointF>("x_goes");
    QTest::addColumn<QPointF>("y_goes");
    QTest::newRow("x up, y left") << MapOrientation::XUp << QPointF(0, -2) << QPointF(-2, 0);
    QTest::newRow("y up, x right") << MapOrientation::YUp << QPointF(2, 0) << QPointF(0, -2);
}

void tst_MapArithmetic::axesPointWhereTheyShould() {
    QFETCH(MapOrientation, orientation);
    MapTransform t;
    t.orientation = orientation;
    t.pixels_per_m = 2.0;
    const QPointF origin = t.toScreen(Vec2(0, 0));
    QTEST(t.toScreen(Vec2(1, 0)) - origin, "x_goes");
    QTEST(t.toScreen(Vec2(0, 1)) - origin, "y_goes");
    // A painter's rotation turns "up" clockwise; yaw 0 looks along x.
    for (const double yaw : {0.0, 0.7, -2.0}) {
        const QPointF along = t.toScreen(Vec2(std::cos(yaw), std::sin(yaw))) - origin;
        const double turn = t.screenRotation_rad(yaw);
        QVERIFY(qAbs(along.x() - 2.0 * std::sin(turn)) < 1e-9);
        QVERIFY(qAbs(along.y() + 2.0 * std::cos(turn)) < 1e-9);
    }
}

void tst_MapArithmetic::screenAndMapAreInverse_data() {
    QTest::addColumn<MapOrientation>("orientation");
    QTest::newRow("x up") << MapOrientation::XUp;
    QTest::newRow("y up") << MapOrientation::YUp;
}

void tst_MapArithmetic::screenAndMapAreInverse() {
    QFETCH(MapOrientation, orientation);
    MapTransform t{orientation, Vec2(31.0, -8.0), 7.3, QSizeF(801, 433)};
    for (const Vec2& point : {Vec2(0, 0), Vec2(-120.5, 33.25), Vec2(1e4, -1e4)})
        QVERIFY((t.toMap(t.toScreen(point)) - point).norm() < 1e-8);
    const Rectangle seen = t.visible();
    QVERIFY(t.toScreen(seen).left() < 1e-6 && qAbs(t.toScreen(seen).width() - 801) < 1e-6);
}

void tst_MapArithmetic::zoomKeepsTheGroundUnderTheCursor() {
    MapTransform t;
    const QPointF cursor(17.0, 402.0);
    const Vec2 before = t.toMap(cursor);
    t.zoomAt(cursor, 3.0);
    QVERIFY((t.toMap(cursor) - before).norm() < 1e-9);
    QCOMPARE(t.pixels_per_m, 15.0);
}

void tst_MapArithmetic::zoomStaysWithinLimits() {
    MapTransform t;
    t.zoomAt(QPointF(0, 0), 1e9);
    QCOMPARE(t.pixels_per_m, MapTransform::maximum_scale);
    t.zoomAt(QPointF(0, 0), 1e-12);
    QCOMPARE(t.pixels_per_m, MapTransform::minimum_scale);
}

void tst_MapArithmetic::panMovesTheGroundWithTheHand() {
    MapTransform t;
    const QPointF before = t.toScreen(Vec2(3, 4));
    t.pan(QPointF(12, -5));
    QVERIFY((t.toScreen(Vec2(3, 4)) - before - QPointF(12, -5)).manhattanLength() < 1e-9);
}

void tst_MapArithmetic::fitShowsAllOfIt_data() {
    QTest::addColumn<MapOrientation>("orientation");
    QTest::addColumn<Vec2>("size");
    for (const auto orientation : {MapOrientation::XUp, MapOrientation::YUp}) {
        QTest::addRow("%d square", int(orientation)) << orientation << Vec2(200, 200);
        QTest::addRow("%d long in x", int(orientation)) << orientation << Vec2(500, 20);
        QTest::addRow("%d long in y", int(orientation)) << orientation << Vec2(20, 500);
    }
}

void tst_MapArithmetic::fitShowsAllOfIt() {
    QFETCH(MapOrientation, orientation);
    QFETCH(Vec2, size);
    MapTransform t;
    t.orientation = orientation;
    const Rectangle world{Vec2(10, 20), Vec2(10, 20) + size};
    t.fit(world, 32.0);
    const QRectF on_screen = t.toScreen(world);
    QVERIFY(QRectF(31.9, 31.9, 640 - 63.8, 480 - 63.8).contains(on_screen));
    QVERIFY(qAbs(on_screen.width() - 576) < 1e-6 || qAbs(on_screen.height() - 416) < 1e-6);
}

void tst_MapArithmetic::fitIgnoresNothing() {
    MapTransform t;
    const MapTransform before = t;
    t.fit(Rectangle{Vec2(5, 5), Vec2(5, 9)});
    QCOMPARE(t, before);
}

void tst_MapArithmetic::stepsAreRound_data() {
    QTest::addColumn<double>("maximum");
    QTest::addColumn<double>("step");
    QTest::newRow("just one") << 1.0 << 1.0;
    QTest::newRow("two") << 4.9 << 2.0;
    QTest::newRow("five") << 9.9 << 5.0;
    QTest::newRow("small") << 0.03 << 0.02;
    QTest::newRow("large") << 720.0 << 500.0;
    QTest::newRow("nonsense") << -1.0 << 1.0;
}

void tst_MapArithmetic::stepsAreRound() {
    QFETCH(double, maximum);
    QFETCH(double, step);
    QVERIFY(qAbs(roundStep(maximum) - step) < 1e-12);
}

void tst_MapArithmetic::gripsAreFound_data() {
    QTest::addColumn<Vec2>("at_m");
    QTest::addColumn<bool>("found");
    QTest::addColumn<int>("x");
    QTest::addColumn<int>("y");
    QTest::newRow("low corner") << Vec2(-10, -10) << true << -1 << -1;
    QTest::newRow("high corner, a little off") << Vec2(10.5, 9.5) << true << 1 << 1;
    QTest::newRow("edge") << Vec2(0, 10) << true << 0 << 1;
    QTest::newRow("inside") << Vec2(2, 3) << true << 0 << 0;
    QTest::newRow("outside") << Vec2(30, 3) << false << 0 << 0;
}

void tst_MapArithmetic::gripsAreFound() {
    QFETCH(Vec2, at_m);
    QFETCH(bool, found);
    const Rectangle area{Vec2(-10, -10), Vec2(10, 10)};
    const MapTransform t;
    const auto grip = gripAt(area, t, t.toScreen(at_m));
    QCOMPARE(grip.has_value(), found);
    if (grip) {
        QTEST(grip->x, "x");
        QTEST(grip->y, "y");
    }
}

void tst_MapArithmetic::cornerDragResizes() {
    const Rectangle area{Vec2(0, 0), Vec2(20, 10)};
    const Rectangle corner = dragged(area, {{1, 1}, Vec2(20, 10), Vec2(24.8, 12.1)}, std::nullopt);
    QCOMPARE(corner, (Rectangle{Vec2(0, 0), Vec2(25, 12)}));
    const Rectangle edge = dragged(area, {{-1, 0}, Vec2(0, 5), Vec2(-3.1, 77)}, std::nullopt);
    QCOMPARE(edge, (Rectangle{Vec2(-3, 0), Vec2(20, 10)}));
}

void tst_MapArithmetic::dragBeyondTheOtherSideSwaps() {
    const Rectangle area{Vec2(0, 0), Vec2(20, 10)};
    QCOMPARE(dragged(area, {{1, 0}, Vec2(20, 5), Vec2(-6, 5)}, std::nullopt), (Rectangle{Vec2(-6, 0), Vec2(0, 10)}));
}

void tst_MapArithmetic::middleDragMovesAndStaysInTheWorld() {
    const Rectangle world{Vec2(-30, -30), Vec2(30, 30)};
    const Rectangle area{Vec2(0, 0), Vec2(20, 10)};
    QCOMPARE(dragged(area, {{}, Vec2(5, 5), Vec2(10, 2)}, world), (Rectangle{Vec2(5, -3), Vec2(25, 7)}));
    QCOMPARE(dragged(area, {{}, Vec2(5, 5), Vec2(500, 5)}, world), (Rectangle{Vec2(10, 0), Vec2(30, 10)}));
}

void tst_MapArithmetic::spanSnapsAndStaysInTheWorld() {
    const Rectangle world{Vec2(-30, -30), Vec2(30, 30)};
    QCOMPARE(spanned(Vec2(9.9, -99), Vec2(-5.2, 3.3), world), (Rectangle{Vec2(-5, -30), Vec2(10, 3.5)}));
}

void tst_MapArithmetic::namesMoveAside_data() {
    QTest::addColumn<std::vector<QRectF>>("taken");
    QTest::addColumn<QPointF>("middle");
    const QRectF below(80, 110, 40, 16);
    const QRectF right(110, 90, 40, 20);
    const QRectF left(50, 90, 40, 20);
    const QRectF above(80, 70, 40, 20);
    using Boxes = std::vector<QRectF>;
    QTest::newRow("below when it is free") << Boxes{} << QPointF(100, 117);
    QTest::newRow("right of what is below") << Boxes{below} << QPointF(130, 100);
    QTest::newRow("left of what is right") << Boxes{below, right} << QPointF(70, 100);
    QTest::newRow("above the rest") << Boxes{below, right, left} << QPointF(100, 83);
    QTest::newRow("farther where all is taken nearby") << Boxes{below, right, left, above} << QPointF(100, 133);
}

void tst_MapArithmetic::namesMoveAside() {
    QFETCH(std::vector<QRectF>, taken);
    const auto places = placeLabels({{QPointF(100, 100), 12.0, QSizeF(36, 10), false}}, taken);
    QVERIFY(places[0]);
    QTEST(places[0]->center(), "middle");
}

void tst_MapArithmetic::nameWithoutRoomIsLeftOutUnlessItMustShow() {
    LabelWish wish{QPointF(100, 100), 12.0, QSizeF(36, 10), false};
    const std::vector<QRectF> everything{QRectF(0, 0, 200, 200)};
    QVERIFY(!placeLabels({wish}, everything)[0]);
    wish.must_show = true;
    QCOMPARE(placeLabels({wish}, everything)[0]->center(), QPointF(100, 117));
}

void tst_MapArithmetic::earlierNamesWin() {
    const LabelWish first{QPointF(100, 100), 12.0, QSizeF(36, 10), false};
    const LabelWish second{QPointF(104, 100), 12.0, QSizeF(36, 10), false};
    const auto places = placeLabels({first, second}, {});
    QCOMPARE(places[0]->center(), QPointF(100, 117));
    QCOMPARE(places[1]->center(), QPointF(134, 100));
}

void tst_MapArithmetic::straightTrailCostsTwoPoints() {
    Trail trail;
    for (int i = 0; i < 200; ++i)
        trail.add(Vec3(i * 0.4, 0.02 * std::sin(i), 0.1 * std::sin(i)));
    QCOMPARE(trail.points_m().size(), std::size_t(2));
    QCOMPARE(trail.points_m().back().x(), 199 * 0.4);
}

void tst_MapArithmetic::trailKeepsBends() {
    Trail trail;
    std::vector<Vec2> flown;
    for (int i = 0; i < 500; ++i)
        flown.push_back(10.0 * Vec2(std::cos(i * 0.05), std::sin(i * 0.05)));
    for (const Vec2& point : flown)
        trail.add(Vec3(point.x(), point.y(), 2.0));
    QVERIFY(trail.points_m().size() < flown.size() / 2);
    for (const Vec2& point : trail.points_m())
        QVERIFY(qAbs(point.norm() - 10.0) < 1e-9);
    for (std::size_t i = 1; i < trail.points_m().size(); ++i) {
        const Vec2 middle = (trail.points_m()[i] + trail.points_m()[i - 1]) / 2.0;
        QVERIFY2(10.0 - middle.norm() < 0.12, "the chord leaves the circle");
    }
}

/// Straight on as the map shows it, over a hill.
void tst_MapArithmetic::trailKeepsClimbs() {
    Trail trail;
    for (int i = 0; i <= 100; ++i)
        trail.add(Vec3(i * 0.4, 0.0, i < 50 ? i * 0.4 : (100 - i) * 0.4));
    QCOMPARE(trail.heights_m().size(), trail.points_m().size());
    QVERIFY(trail.points_m().size() >= 3 && trail.points_m().size() < 10);
    QVERIFY(*std::ranges::max_element(trail.heights_m()) > 19.0);
    QCOMPARE(trail.heights_m().front(), 0.0);
}

void tst_MapArithmetic::trailIgnoresNonsense() {
    Trail trail;
    trail.add(Vec3(qQNaN(), 0.0, 0.0));
    trail.add(Vec3(1.0, 1.0, 1.0));
    trail.add(Vec3(1.0, 1.0, 1.0));
    QCOMPARE(trail.points_m().size(), std::size_t(1));
    trail.clear();
    QVERIFY(trail.points_m().empty());
}

void tst_MapArithmetic::trailIsInterruptedWherePosesAreMissing() {
    Trail trail;
    for (const double x : {0.0, 2.0, 4.0, 60.0, 62.0, 64.0})
        trail.add(Vec3(x, 0.0, 1.0));
    QCOMPARE(trail.points_m().size(), std::size_t(5));
    QCOMPARE(trail.points_m()[1], Vec2(4.0, 0.0));
    QVERIFY(trail.points_m()[2].hasNaN() && std::isnan(trail.heights_m()[2]));
    QCOMPARE(trail.points_m()[3], Vec2(60.0, 0.0));
    QCOMPARE(trail.points_m()[4], Vec2(64.0, 0.0));
}

USAR_TEST(tst_MapArithmetic)

} // namespace tst_map_arithmetic

#include "tst_map_arithmetic.moc"
