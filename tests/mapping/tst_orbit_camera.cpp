#include <QTest>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/mapping/relief/orbit_camera.h"
#include "tests/suite/suite.h"

namespace tst_orbit_camera {

using namespace usar;
using namespace usar::mapping;

namespace {

constexpr int width_px = 320;
constexpr int height_px = 240;

OrbitCamera cameraAt(const Vec3& target_m, double yaw_deg, double elevation_deg, double distance_m) {
    return {target_m, radians(yaw_deg), radians(elevation_deg), distance_m, radians(40.0)};
}

} // namespace

class tst_OrbitCamera : public QObject {
    Q_OBJECT
private slots:
    void pointsAreSeenWhereTheCameraSaysSo_data();
    void pointsAreSeenWhereTheCameraSaysSo();
    void whatIsNearOrBehindHasNoPlace();
    void aPlaceOfThePictureIsAPointAgain();
    void theWholeAreaIsShown_data();
    void theWholeAreaIsShown();
    void aCameraKeepsItsLimits();
};

void tst_OrbitCamera::pointsAreSeenWhereTheCameraSaysSo_data() {
    QTest::addColumn<double>("yaw_deg");
    QTest::addColumn<double>("elevation_deg");
    QTest::addColumn<double>("exaggeration");
    QTest::addColumn<Vec3>("point_m");
    QTest::addColumn<double>("x_px");
    QTest::addColumn<double>("y_px");
    QTest::addColumn<double>("distance_m");
    // With a field of view of 90 degrees, half the height of the picture is as long as the distance.
    QTest::newRow("the target is in the middle") << 90.0 << 30.0 << 1.0 << Vec3(3, 4, 5) << 160.0 << 120.0 << 10.0;
    QTest::newRow("east is right of it") << 90.0 << 30.0 << 1.0 << Vec3(8, 4, 5) << 220.0 << 120.0 << 10.0;
    QTest::newRow("looking east, north is left") << 0.0 << 30.0 << 1.0 << Vec3(3, 9, 5) << 100.0 << 120.0 << 10.0;
    QTest::newRow("from above, north is up") << 90.0 << 90.0 << 1.0 << Vec3(3, 9, 5) << 160.0 << 60.0 << 10.0;
    QTest::newRow("from above, high is near") << 90.0 << 90.0 << 1.0 << Vec3(8, 4, 10) << 280.0 << 120.0 << 5.0;
    QTest::newRow("exaggerated, it is nearer still") << 90.0 << 90.0 << 1.5 << Vec3(3, 4, 9) << 160.0 << 120.0 << 4.0;
    QTest::newRow("north is farther away") << 90.0 << 60.0 << 1.0 << Vec3(3, 14, 5) << 160.0
                                           << 120.0 - 120.0 * 10 * std::sin(radians(60.0)) / 15.0 << 15.0;
}

void tst_OrbitCamera::pointsAreSeenWhereTheCameraSaysSo() {
    QFETCH(double, yaw_deg);
    QFETCH(double, elevation_deg);
    QFETCH(double, exaggeration);
    QFETCH(Vec3, point_m);
    QFETCH(double, x_px);
    QFETCH(double, y_px);
    QFETCH(double, distance_m);
    OrbitCamera camera = cameraAt({3, 4, 5}, yaw_deg, elevation_deg, 10.0);
    camera.field_of_view_rad = radians(90.0);
    const ReliefProjection projection(camera, width_px, height_px, exaggeration);
    const auto seen = projection.project(point_m);
    QVERIFY(seen);
    QVERIFY(std::abs(seen->x_px - x_px) < 1e-6);
    QVERIFY(std::abs(seen->y_px - y_px) < 1e-6);
    QVERIFY(std::abs(1.0 / seen->nearness_per_m - distance_m) < 1e-6);
    QVERIFY((projection.unproject(*seen) - point_m).norm() < 1e-9);
}

void tst_OrbitCamera::whatIsNearOrBehindHasNoPlace() {
    const ReliefProjection projection(cameraAt({0, 0, 0}, 90.0, 90.0, 10.0), width_px, height_px);
    QVERIFY(projection.project({0, 0, 9.7}));
    QVERIFY(!projection.project({0, 0, 9.9}));
    QVERIFY(!projection.project({0, 0, 11.0}));
    QVERIFY(!projection.project({0, 0, std::nan("")}));
}

void tst_OrbitCamera::aPlaceOfThePictureIsAPointAgain() {
    const ReliefProjection projection(cameraAt({3, 4, 1}, 70.0, 25.0, 40.0), width_px, height_px, 2.0);
    const Vec3 point_m(5.0, 9.0, 2.5);
    const auto seen = projection.project(point_m);
    const auto again = projection.onPlane(seen->x_px, seen->y_px, 2.5);
    QVERIFY(again);
    QVERIFY((*again - point_m).norm() < 1e-9);
    QVERIFY(!projection.onPlane(160.0, -2000.0, 2.5)); // the sky
}

void tst_OrbitCamera::theWholeAreaIsShown_data() {
    QTest::addColumn<Rectangle>("area");
    QTest::addColumn<double>("yaw_deg");
    QTest::addColumn<double>("elevation_deg");
    QTest::addColumn<double>("exaggeration");
    QTest::newRow("square") << Rectangle{{0, 0}, {50, 50}} << 90.0 << 35.0 << 1.0;
    QTest::newRow("wide strip") << Rectangle{{-300, 10}, {400, 20}} << 90.0 << 35.0 << 1.0;
    QTest::newRow("deep strip") << Rectangle{{-300, 10}, {400, 20}} << 0.0 << 20.0 << 3.0;
    QTest::newRow("from above") << Rectangle{{-30, 10}, {40, 200}} << 10.0 << 90.0 << 1.0;
}

void tst_OrbitCamera::theWholeAreaIsShown() {
    QFETCH(Rectangle, area);
    QFETCH(double, yaw_deg);
    QFETCH(double, elevation_deg);
    QFETCH(double, exaggeration);
    std::vector<Vec3> points;
    for (const double x_m : {area.min_m.x(), area.center_m().x(), area.max_m.x()})
        for (const double y_m : {area.min_m.y(), area.max_m.y()})
            points.emplace_back(x_m, y_m, 2.0 + 0.05 * x_m);
    const OrbitCamera before = cameraAt({0, 0, 0}, yaw_deg, elevation_deg, 1.0);
    const OrbitCamera camera = before.showing(points, double(width_px) / height_px, exaggeration);
    const ReliefProjection projection(camera, width_px, height_px, exaggeration);
    double left_px = 1e9, right_px = 1e9, top_px = 1e9, bottom_px = 1e9; // Distances from the edges.
    for (const Vec3& point : points) {
        const auto seen = projection.project(point);
        QVERIFY(seen);
        left_px = std::min(left_px, seen->x_px);
        right_px = std::min(right_px, width_px - seen->x_px);
        top_px = std::min(top_px, seen->y_px);
        bottom_px = std::min(bottom_px, height_px - seen->y_px);
    }
    QVERIFY(std::min({left_px, right_px, top_px, bottom_px}) >= 0.0);
    QVERIFY(std::min({left_px, right_px, top_px, bottom_px}) < 0.1 * width_px); // It is no smaller than it has to be.
    QVERIFY(std::abs(left_px - right_px) < 2.0 || std::abs(top_px - bottom_px) < 2.0);
    QCOMPARE(before.showing({}, 1.0), before);
}

void tst_OrbitCamera::aCameraKeepsItsLimits() {
    OrbitCamera camera = cameraAt({1, 2, 3}, 800.0, 120.0, 0.0);
    QCOMPARE(camera.limited().elevation_rad, OrbitCamera::highest_elevation_rad);
    QCOMPARE(camera.limited().distance_m, OrbitCamera::least_distance_m);
    QVERIFY(std::abs(camera.limited().yaw_rad - radians(80.0)) < 1e-9);
    camera = {Vec3(std::nan(""), 0, 0), std::nan(""), -1.0, INFINITY, std::nan("")};
    QCOMPARE(camera.limited().target_in_map_m, Vec3(0, 0, 0));
    QCOMPARE(camera.limited().elevation_rad, OrbitCamera::lowest_elevation_rad);
    QCOMPARE(camera.limited().distance_m, OrbitCamera().distance_m);
    QCOMPARE(camera.limited(), camera.limited().limited());
}

USAR_TEST(tst_OrbitCamera)

} // namespace tst_orbit_camera

#include "tst_orbit_camera.moc"
