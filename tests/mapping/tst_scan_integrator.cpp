#include <QTest>

#include <algorithm>
#include <cmath>

#include "core/mapping/scan_integrator.h"
#include "tests/suite/suite.h"

namespace tst_scan_integrator {

using namespace usar;
using namespace usar::mapping;

namespace {

constexpr double resolution_rad = pi / 180.0;

/// Belly scanner: x axis down, scan plane across track (robots-and-worlds.md 3.1).
Pose bellyScanner(const Vec3& position_m, double yaw_rad = 0.0) {
    return {position_m, 0.0, pi / 2.0, yaw_rad};
}

Beams beamsOf(const std::vector<double>& ranges_m) {
    return {ranges_m, resolution_rad, resolution_rad * double(ranges_m.size() - 1), 20.0};
}

/// Ranges of the belly scanner over a plane z = 0, seen from `altitude_m`.
std::vector<double> flatGround(double altitude_m) {
    std::vector<double> ranges_m;
    for (int k = 0; k <= 180; ++k)
        ranges_m.push_back(std::min(20.0, altitude_m / std::max(1e-9, std::cos(radians(k - 90)))));
    return ranges_m;
}

/// Two beams from a scanner at y = 0 that hit exactly these points (y, z): resolution and field of view are made to
/// fit.
struct TwoBeams {
    std::vector<double> ranges_m;
    Beams beams;
    TwoBeams(const Vec2& left_yz_m, const Vec2& right_yz_m, double altitude_m) {
        const auto angle = [&](const Vec2& p) { return std::atan2(p.x(), altitude_m - p.y()); };
        const auto range = [&](const Vec2& p) { return std::hypot(p.x(), altitude_m - p.y()); };
        ranges_m = {range(left_yz_m), range(right_yz_m)};
        const double step_rad = angle(right_yz_m) - angle(left_yz_m);
        beams = {ranges_m, step_rad, -2.0 * angle(left_yz_m), 20.0};
    }
};

} // namespace

class tst_ScanIntegrator : public QObject {
    Q_OBJECT
private slots:
    void beamsFanOutCounterClockwise();
    void hitsTurnWithTheRobot_data();
    void hitsTurnWithTheRobot();
    void noHitIsNoHit_data();
    void noHitIsNoHit();
    void theCellHalfWayGetsTheAverage();
    void heightsBetweenBeamsLieOnTheLine();
    void joinsBeamsOnlyWithinTheGapLimit_data();
    void joinsBeamsOnlyWithinTheGapLimit();
    void joinsConsecutiveScansWithoutHoles_data();
    void joinsConsecutiveScansWithoutHoles();
    void aSlopeComesOutTrueToAFractionOfACell_data();
    void aSlopeComesOutTrueToAFractionOfACell();
    void breakingTheStripLeavesTheGapOpen();
    void aPoseThatIsNotFiniteWritesNothing();
    void aScanOfAnotherSizeIsNotJoined();
    void fillsAreMarkedByNoHitsAndCarryTheLine();
};

void tst_ScanIntegrator::beamsFanOutCounterClockwise() {
    HeightMap map(0.25);
    ScanIntegrator integrator;
    const std::vector<double> ranges_m{10.0, 10.0, 10.0};
    integrator.integrate({ranges_m, pi / 2.0, pi, 20.0}, Pose{}, {1}, map);
    const std::vector<Vec3>& hits = integrator.lastHits();
    QVERIFY((hits[0] - Vec3(0, -10, 0)).norm() < 1e-9);
    QVERIFY((hits[1] - Vec3(10, 0, 0)).norm() < 1e-9);
    QVERIFY((hits[2] - Vec3(0, 10, 0)).norm() < 1e-9);
}

void tst_ScanIntegrator::hitsTurnWithTheRobot_data() {
    QTest::addColumn<double>("yaw_deg");
    QTest::addColumn<double>("x_m");
    QTest::addColumn<double>("y_m");
    QTest::newRow("flying along x, first beam to the right") << 0.0 << 0.0 << -6.0;
    QTest::newRow("flying along y") << 90.0 << 6.0 << 0.0;
    QTest::newRow("flying back") << 180.0 << 0.0 << 6.0;
}

void tst_ScanIntegrator::hitsTurnWithTheRobot() {
    QFETCH(double, yaw_deg);
    QFETCH(double, x_m);
    QFETCH(double, y_m);
    HeightMap map(0.25);
    ScanIntegrator integrator;
    const std::vector<double> ranges_m{6.0 * std::sqrt(2.0), 6.0, 6.0 * std::sqrt(2.0)};
    integrator.integrate({ranges_m, pi / 4.0, pi / 2.0, 20.0}, bellyScanner({1, 2, 6}, radians(yaw_deg)), {1}, map);
    const std::vector<Vec3>& hits = integrator.lastHits();
    QVERIFY((hits[0] - Vec3(1 + x_m, 2 + y_m, 0)).norm() < 1e-9);
    QVERIFY((hits[1] - Vec3(1, 2, 0)).norm() < 1e-9);
    QVERIFY((hits[2] - Vec3(1 - x_m, 2 - y_m, 0)).norm() < 1e-9);
    QVERIFY(std::abs(map.height_m(map.cellAt(hits[1].head<2>())).value_or(9.0f)) < 1e-5f);
}

void tst_ScanIntegrator::noHitIsNoHit_data() {
    QTest::addColumn<double>("range_m");
    QTest::newRow("maximum range") << 20.0;
    QTest::newRow("beyond it") << 20.5;
    QTest::newRow("not a number") << qQNaN();
    QTest::newRow("infinite") << qInf();
    QTest::newRow("zero") << 0.0;
    QTest::newRow("negative") << -1.0;
}

void tst_ScanIntegrator::noHitIsNoHit() {
    QFETCH(double, range_m);
    HeightMap map(0.25);
    ScanIntegrator integrator;
    const std::vector<double> ranges_m{5.0, range_m, 5.0};
    integrator.integrate(beamsOf(ranges_m), bellyScanner({0, 0, 6}), {1}, map);
    QVERIFY(integrator.lastHits()[0].allFinite());
    QVERIFY(integrator.lastHits()[1].array().isNaN().all());
    QVERIFY(map.knownCellCount() <= 2);
}

void tst_ScanIntegrator::theCellHalfWayGetsTheAverage() {
    HeightMap map(0.5);
    ScanIntegrator integrator;
    const TwoBeams scan({-0.25, 1.0}, {0.75, 2.0}, 6.0); // centers of the cells -1 and 1
    integrator.integrate(scan.beams, bellyScanner({0.25, 0, 6}), {1}, map);
    QCOMPARE(map.knownCellCount(), std::size_t(3));
    QVERIFY(std::abs(map.height_m({0, -1}).value() - 1.0f) < 1e-5f);
    QVERIFY(std::abs(map.height_m({0, 0}).value() - 1.5f) < 1e-5f);
    QVERIFY(std::abs(map.height_m({0, 1}).value() - 2.0f) < 1e-5f);
}

void tst_ScanIntegrator::heightsBetweenBeamsLieOnTheLine() {
    HeightMap map(0.1);
    ScanIntegrator integrator;
    const TwoBeams scan({0.05, 0.0}, {1.05, 1.0}, 6.0);
    integrator.integrate(scan.beams, bellyScanner({0.05, 0, 6}), {1}, map);
    for (std::int32_t row = 0; row <= 10; ++row)
        QVERIFY2(std::abs(map.height_m({0, row}).value_or(-99.0f) - 0.1f * float(row)) < 1e-4f,
                 qPrintable(QString("row %1").arg(row)));
    QCOMPARE(map.knownCellCount(), std::size_t(11));
}

void tst_ScanIntegrator::joinsBeamsOnlyWithinTheGapLimit_data() {
    QTest::addColumn<double>("over_ground_m");
    QTest::addColumn<double>("height_jump_m");
    QTest::addColumn<double>("cell_size_m");
    QTest::addColumn<bool>("joined");
    QTest::newRow("beams 60 degrees off nadir") << 0.42 << 0.0 << 0.1 << true;
    QTest::newRow("just inside the limit") << 1.45 << 0.0 << 0.25 << true;
    QTest::newRow("just outside the limit") << 1.55 << 0.0 << 0.25 << false;
    QTest::newRow("a bush") << 0.8 << 1.2 << 0.25 << true;
    QTest::newRow("a tree") << 0.8 << 4.0 << 0.25 << false;
    QTest::newRow("down from a crown") << 0.8 << -4.0 << 0.25 << false;
    QTest::newRow("coarse cells stretch the limit") << 1.95 << 0.0 << 1.0 << true;
    QTest::newRow("but not for heights") << 1.95 << 1.7 << 1.0 << false;
}

void tst_ScanIntegrator::joinsBeamsOnlyWithinTheGapLimit() {
    QFETCH(double, over_ground_m);
    QFETCH(double, height_jump_m);
    QFETCH(double, cell_size_m);
    QFETCH(bool, joined);
    HeightMap map(cell_size_m);
    ScanIntegrator integrator(1.5);
    const double first_m = cell_size_m * 0.98;
    const TwoBeams scan({first_m, 0.0}, {first_m + over_ground_m, height_jump_m}, 6.0);
    integrator.integrate(scan.beams, bellyScanner({0.01, 0, 6}), {1}, map);
    QCOMPARE(map.knownCellCount() > 2, joined);
    QVERIFY(map.knownCellCount() >= 2);
}

void tst_ScanIntegrator::joinsConsecutiveScansWithoutHoles_data() {
    QTest::addColumn<double>("cell_size_m");
    QTest::addColumn<double>("step_m");
    QTest::newRow("slow, quarter metre cells") << 0.25 << 0.2;
    QTest::newRow("fast, quarter metre cells") << 0.25 << 0.4;
    QTest::newRow("slow, decimetre cells") << 0.1 << 0.2;
    QTest::newRow("fast, decimetre cells") << 0.1 << 0.4;
    QTest::newRow("metre cells") << 1.0 << 0.2;
}

void tst_ScanIntegrator::joinsConsecutiveScansWithoutHoles() {
    QFETCH(double, cell_size_m);
    QFETCH(double, step_m);
    HeightMap map(cell_size_m);
    ScanIntegrator integrator;
    const std::vector<double> ranges_m = flatGround(6.0);
    for (int i = 0; i <= 40; ++i)
        integrator.integrate(beamsOf(ranges_m), bellyScanner({i * step_m, 0, 6}), {std::uint64_t(i)}, map);
    int holes = 0;
    for (double x_m = cell_size_m; x_m < 40 * step_m - cell_size_m; x_m += cell_size_m) {
        for (double y_m = -18.0; y_m < 18.0; y_m += cell_size_m) {
            const std::optional<float> height_m = map.height_m(map.cellAt({x_m, y_m}));
            holes += height_m ? 0 : 1;
            QVERIFY(std::abs(height_m.value_or(0.0f)) < 1e-4f);
        }
    }
    QCOMPARE(holes, 0);
}

void tst_ScanIntegrator::aSlopeComesOutTrueToAFractionOfACell_data() {
    QTest::addColumn<double>("cell_size_m");
    QTest::addColumn<double>("step_m");
    QTest::newRow("quarter metre cells") << 0.25 << 0.15;
    QTest::newRow("decimetre cells") << 0.1 << 0.15;
    QTest::newRow("decimetre cells, in transit") << 0.1 << 0.4;
}

void tst_ScanIntegrator::aSlopeComesOutTrueToAFractionOfACell() {
    QFETCH(double, cell_size_m);
    QFETCH(double, step_m);
    constexpr double slope_x = 0.3, slope_y = 0.2; // ground z = 0.3 x + 0.2 y
    HeightMap map(cell_size_m);
    ScanIntegrator integrator;
    for (double x_m = 0.0; x_m < 10.0; x_m += step_m) {
        std::vector<double> ranges_m;
        for (int k = 0; k <= 180; ++k) {
            const double angle_rad = radians(k - 90); // the beam goes to y = range sin, z = -range cos
            const double closing = std::cos(angle_rad) + slope_y * std::sin(angle_rad);
            ranges_m.push_back(closing > 0.0 ? std::min(20.0, 6.0 / closing) : 20.0);
        }
        integrator.integrate(beamsOf(ranges_m), bellyScanner({x_m, 0, 6.0 + slope_x * x_m}), {1}, map);
    }
    double sum_m2 = 0.0;
    int cells = 0;
    for (double x_m = 0.5; x_m < 9.0; x_m += cell_size_m) {
        for (double y_m = -12.0; y_m < 12.0; y_m += cell_size_m) {
            const GridIndex cell = map.cellAt({x_m, y_m});
            const Vec2 center_m = map.center_m(cell);
            const double error_m =
                double(map.height_m(cell).value_or(99.0f)) - slope_x * center_m.x() - slope_y * center_m.y();
            sum_m2 += error_m * error_m;
            ++cells;
        }
    }
    // A point anywhere in a cell is off its center by cell / sqrt(12) on each axis.
    const double scatter_m = cell_size_m / std::sqrt(12.0) * std::hypot(slope_x, slope_y);
    const double rmse_m = std::sqrt(sum_m2 / cells);
    QVERIFY2(rmse_m < 1.1 * scatter_m, qPrintable(QString("%1 m, scatter %2 m").arg(rmse_m).arg(scatter_m)));
}

void tst_ScanIntegrator::breakingTheStripLeavesTheGapOpen() {
    const auto cellsAfterTwoScans = [](bool broken) {
        HeightMap map(0.25);
        ScanIntegrator integrator;
        const std::vector<double> ranges_m = flatGround(6.0);
        integrator.integrate(beamsOf(ranges_m), bellyScanner({0.1, 0, 6}), {1}, map);
        if (broken)
            integrator.breakStrip();
        const bool keeps_hits = integrator.lastHits().size() == ranges_m.size();
        integrator.integrate(beamsOf(ranges_m), bellyScanner({1.1, 0, 6}), {2}, map);
        return keeps_hits && map.height_m(map.cellAt({0.6, 0.0})).has_value();
    };
    QVERIFY(cellsAfterTwoScans(false));
    QVERIFY(!cellsAfterTwoScans(true));
}

void tst_ScanIntegrator::aPoseThatIsNotFiniteWritesNothing() {
    HeightMap map(0.25);
    ScanIntegrator integrator;
    const std::vector<double> ranges_m = flatGround(6.0);
    for (const Pose& pose : {bellyScanner({qQNaN(), 0, 6}), bellyScanner({0, 0, 6}, qInf())})
        integrator.integrate(beamsOf(ranges_m), pose, {1}, map);
    QCOMPARE(map.knownCellCount(), std::size_t(0));
    QCOMPARE(integrator.lastHits().size(), ranges_m.size());
}

void tst_ScanIntegrator::aScanOfAnotherSizeIsNotJoined() {
    HeightMap map(0.25);
    ScanIntegrator integrator;
    const std::vector<double> ranges_m = flatGround(6.0);
    const std::vector<double> short_scan(ranges_m.begin() + 80, ranges_m.end() - 80);
    integrator.integrate(beamsOf(ranges_m), bellyScanner({0.1, 0, 6}), {1}, map);
    integrator.integrate(beamsOf(short_scan), bellyScanner({1.1, 0, 6}), {2}, map);
    QVERIFY(!map.height_m(map.cellAt({0.6, 0.0})));
    integrator.integrate({}, bellyScanner({1.1, 0, 6}), {3}, map);
    QVERIFY(integrator.lastHits().empty());
}

void tst_ScanIntegrator::fillsAreMarkedByNoHitsAndCarryTheLine() {
    HeightMap map(0.1);
    ScanIntegrator integrator;
    const TwoBeams scan({0.05, 0.0}, {0.55, 0.0}, 6.0);
    integrator.integrate(scan.beams, bellyScanner({0.05, 0, 6}), {42}, map);
    QCOMPARE(map.hits({0, 0}), 1);
    QCOMPARE(map.hits({0, 3}), 0);
    QVERIFY(map.height_m({0, 3}).has_value());
    QVERIFY(map.line({0, 3}) == LineNumber{42});
}

USAR_TEST(tst_ScanIntegrator)

} // namespace tst_scan_integrator

#include "tst_scan_integrator.moc"
