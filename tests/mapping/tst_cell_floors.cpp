#include <QTest>

#include <cmath>
#include <vector>

#include "core/mapping/cell_floors.h"
#include "core/mapping/map_rebuild.h"
#include "tests/suite/suite.h"

namespace tst_cell_floors {

using namespace usar;
using namespace usar::mapping;

constexpr double cell_m = 0.25;

namespace {

/// A round thing with steep sides on flat ground.
double tower(double x_m, double y_m) {
    return std::hypot(x_m, y_m) < 2.1 ? 4.0 : 0.0;
}

double range_m(const Vec3& from_m, const Vec3& ray) {
    for (double range_m = 0.0; range_m < 20.0; range_m += 0.01)
        if (const Vec3 at_m = from_m + range_m * ray; at_m.z() <= tower(at_m.x(), at_m.y()))
            return range_m;
    return 20.0;
}

/// Scans of lanes along x, by default three, the middle one over the tower.
ScanStore flyOverTheTower(double step_m = 0.21, const std::vector<double>& lanes_y_m = {-6.03, 0.04, 6.01}) {
    ScanStore store;
    double time_s = 0.0;
    for (const double y_m : lanes_y_m)
        for (double x_m = -8.0; x_m < 8.0; x_m += step_m) {
            const Vec3 at_m(x_m, y_m, 8.0);
            store.move(Seconds(time_s += 0.2), at_m);
            KeptScan scan{.scanner_in_map = {at_m, 0.0, pi / 2.0, 0.0},
                          .line = {1},
                          .continues = x_m > -8.0,
                          .resolution_rad = radians(1.0),
                          .fov_rad = radians(120.0)};
            const Eigen::Matrix3d turn = scan.scanner_in_map.rotation().toRotationMatrix();
            for (int k = 0; k <= 120; ++k) {
                const double angle_rad = radians(k - 60.0);
                scan.ranges_m.push_back(
                    float(range_m(at_m, turn * Vec3(std::cos(angle_rad), std::sin(angle_rad), 0.0))));
            }
            store.keep(std::move(scan));
        }
    return store;
}

HeightMap integrated(const ScanStore& store) {
    HeightMap map(cell_m);
    ScanIntegrator integrator;
    std::vector<double> ranges_m;
    for (const KeptScan& scan : store.scans()) {
        if (!scan.continues)
            integrator.breakStrip();
        integrator.integrate(scan.beams(ranges_m), scan.scanner_in_map, scan.line, map);
    }
    return map;
}

HeightMap rebuilt(const ScanStore& store) {
    MapRebuild rebuild(store, {}, HeightMap(cell_m));
    while (rebuild.step()) {
    }
    return rebuild.takeMap();
}

/// Root mean square of the errors of cells whose centers are between these distances from the tower's middle.
double error_m(const HeightMap& map, double from_m, double to_m) {
    double sum_m2 = 0.0, cells = 0.0;
    for (double x_m = -3.0; x_m < 3.0; x_m += cell_m)
        for (double y_m = -3.0; y_m < 3.0; y_m += cell_m) {
            const GridIndex cell = map.cellAt({x_m + 0.1, y_m + 0.1});
            const Vec2 center_m = map.center_m(cell);
            const auto height_m = map.height_m(cell);
            if (!height_m || center_m.norm() < from_m || center_m.norm() > to_m)
                continue;
            sum_m2 += std::pow(double(*height_m) - tower(center_m.x(), center_m.y()), 2);
            cells += 1.0;
        }
    return std::sqrt(sum_m2 / cells);
}

} // namespace

class tst_CellFloors : public QObject {
    Q_OBJECT
private slots:
    void aCellWithOneFloorHasTheMeanOfItsHits() {
        CellFloors floors(cell_m);
        HeightMap map(cell_m);
        for (const float z_m : {1.0f, 1.2f}) {
            floors.add({0.1, 0.1, 9.0}, {0.1, 0.1, double(z_m)});
            map.write({0, 0}, z_m, {1});
        }
        floors.settle(map);
        QVERIFY(std::abs(*map.height_m({0, 0}) - 1.1f) < 0.01f);
    }

    /// Without another look at the edge, the floor that was hit more tells.
    void ofTwoFloorsThatWereNotLookedAtTheOneWithMoreHitsCounts() {
        CellFloors floors(cell_m);
        HeightMap map(cell_m);
        for (const double z_m : {5.0, 0.0, 5.1, 5.2}) {
            floors.add({0.1, 0.1, 9.0}, {0.1, 0.1, z_m});
            map.write({0, 0}, float(z_m), {1});
        }
        floors.settle(map);
        QVERIFY(std::abs(*map.height_m({0, 0}) - 5.1f) < 0.01f);
    }

    void leavesUnknownCellsUnknown() {
        CellFloors floors(cell_m);
        HeightMap map(cell_m);
        map.write({0, 0}, 1.0f, {1});
        floors.add({0.4, 0.1, 9.0}, {0.4, 0.1, 1.0});
        floors.settle(map);
        QVERIFY(!map.height_m({1, 0}));
        QCOMPARE(map.knownCellCount(), std::size_t(1));
    }

    void ignoresGarbledHits_data() {
        QTest::addColumn<double>("x_m");
        QTest::addColumn<double>("z_m");
        QTest::newRow("no place") << std::nan("") << 0.0;
        QTest::newRow("far away") << 1e300 << 0.0;
        QTest::newRow("no height") << 0.1 << std::nan("");
        QTest::newRow("endlessly deep") << 0.1 << -std::numeric_limits<double>::infinity();
        QTest::newRow("at the scanner itself") << 0.1 << 9.0;
    }
    void ignoresGarbledHits() {
        QFETCH(double, x_m);
        QFETCH(double, z_m);
        CellFloors floors(cell_m);
        HeightMap map(cell_m);
        map.write({0, 0}, 1.0f, {1});
        floors.add({0.1, 0.1, 9.0}, {x_m, 0.1, z_m});
        floors.add({0.1, 0.1, 9.0}, {0.1, 0.1, 2.0}); // One that is whole comes through all the same.
        floors.settle(map);
        QCOMPARE(*map.height_m({0, 0}), 2.0f);
    }

    void openGroundBesideAnEdgeIsNearerToTheTruthThanByTheRunningMean() {
        const ScanStore store = flyOverTheTower();
        const HeightMap running_mean = integrated(store);
        const HeightMap floors = rebuilt(store);
        const double floors_m = error_m(floors, 2.1, 2.6), mean_m = error_m(running_mean, 2.1, 2.6);
        QVERIFY2(floors_m < 0.4 * mean_m, qPrintable(QString("%1 m, the running mean %2 m").arg(floors_m).arg(mean_m)));
        const double inside_m = error_m(floors, 0.0, 1.6);
        QVERIFY2(inside_m < 0.3, qPrintable(QString::number(inside_m)));
    }

    /// Two scans of a fast robot are farther apart than cells are wide, and nothing joins hits on a tower and below it.
    void fillsInCellsAtAnEdgeOnTheSideThatBeamsTell() {
        int filled = 0, right = 0;
        for (const double lane_y_m : {-6.03, -3.02, -1.01, 0.04}) {
            const ScanStore store = flyOverTheTower(0.4, {lane_y_m});
            const HeightMap before = integrated(store);
            const HeightMap after = rebuilt(store);
            for (double x_m = -3.0; x_m < 3.0; x_m += cell_m)
                for (double y_m = -3.0; y_m < 3.0; y_m += cell_m) {
                    const GridIndex cell = after.cellAt({x_m + 0.1, y_m + 0.1});
                    if (before.height_m(cell) || !after.height_m(cell))
                        continue;
                    const Vec2 center_m = after.center_m(cell);
                    QVERIFY(std::abs(center_m.norm() - 2.1) < 0.8);
                    QCOMPARE(after.hits(cell), 0);
                    const double error_m = std::abs(double(*after.height_m(cell)) - tower(center_m.x(), center_m.y()));
                    ++filled;
                    right += error_m < 0.5 ? 1 : 0;
                }
        }
        QVERIFY2(filled >= 20, qPrintable(QString::number(filled)));
        QVERIFY2(right >= 0.9 * filled, qPrintable(QString("%1 of %2").arg(right).arg(filled)));
    }

    /// A lane on one side sees nothing of the ground behind the tower, and nobody guesses it.
    void leavesShadowsUnknown() {
        const ScanStore store = flyOverTheTower(0.4, {-6.03});
        const HeightMap before = integrated(store);
        const HeightMap after = rebuilt(store);
        QVERIFY(after.knownCellCount() > before.knownCellCount());
        for (double y_m = 2.6; y_m < 5.0; y_m += cell_m) {
            QVERIFY(!before.height_m(before.cellAt({0.1, y_m})));
            QVERIFY(!after.height_m(after.cellAt({0.1, y_m})));
        }
    }
};

USAR_TEST(tst_CellFloors)

} // namespace tst_cell_floors

#include "tst_cell_floors.moc"
