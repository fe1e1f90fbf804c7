#include <QTest>

#include <cmath>
#include <functional>
#include <vector>

#include "core/mapping/cell_floors.h"
#include "core/mapping/map_rebuild.h"
#include "tests/suite/suite.h"

namespace tst_cell_floors {

using namespace usar;
using namespace usar::mapping;

constexpr double cell_m = 0.25;

/// A beam in the plane of x and z that hits the cell (0, 0).
struct Beam {
    double x_m;   ///< The hit is so far from the center of the cell.
    double z_m;   ///< It is so high.
    double slope; ///< rise over run, toward where it came from; positive: it flies toward +x
};
using Beams = std::vector<Beam>;

namespace {

/// The height that the cell (0, 0) gets when its neighbors have the heights of `around`; `filled_m` is what it is
/// filled with.
float settled_m(const Beams& beams, const std::function<float(int column)>& around, float filled_m = 0.0f) {
    CellFloors floors(cell_m);
    HeightMap map(cell_m);
    map.fill({0, 0}, filled_m, {1});
    const auto hit = [&](const Vec3& at_m, const Vec3& from_m) {
        floors.add(from_m, at_m);
        map.write(map.cellAt(at_m.head<2>()), static_cast<float>(at_m.z()), {1});
    };
    for (int column = -2; column <= 2; ++column)
        for (int row = -2; row <= 2; ++row)
            if (column != 0 || row != 0) {
                const Vec2 at_m = map.center_m({column, row});
                hit({at_m.x(), at_m.y(), around(column)}, {at_m.x(), at_m.y(), 20.0});
            }
    for (const Beam& beam : beams) {
        const Vec3 at_m(cell_m / 2.0 + beam.x_m, cell_m / 2.0, beam.z_m);
        hit(at_m, at_m + Vec3(-1.0, 0.0, beam.slope) * 5.0);
    }
    floors.settle(map);
    return map.height_m({0, 0}).value_or(std::nanf(""));
}

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

/// Scans of three lanes along x, the middle one over the tower.
ScanStore flyOverTheTower() {
    ScanStore store;
    double time_s = 0.0;
    for (const double y_m : {-6.03, 0.04, 6.01})
        for (double x_m = -8.0; x_m < 8.0; x_m += 0.21) {
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

/// Root mean square of the errors of cells whose centers are within half a meter of the tower's edge.
double edgeError_m(const HeightMap& map) {
    double sum_m2 = 0.0, cells = 0.0;
    for (double x_m = -3.0; x_m < 3.0; x_m += cell_m)
        for (double y_m = -3.0; y_m < 3.0; y_m += cell_m) {
            const GridIndex cell = map.cellAt({x_m + 0.1, y_m + 0.1});
            const Vec2 center_m = map.center_m(cell);
            const auto height_m = map.height_m(cell);
            if (!height_m || std::abs(center_m.norm() - 2.1) > 0.5)
                continue;
            sum_m2 += std::pow(double(*height_m) - tower(center_m.x(), center_m.y()), 2);
            cells += 1.0;
        }
    return std::sqrt(sum_m2 / cells);
}

} // namespace

} // namespace tst_cell_floors

Q_DECLARE_METATYPE(tst_cell_floors::Beams)

namespace tst_cell_floors {

class tst_CellFloors : public QObject {
    Q_OBJECT
private slots:
    void tellsWhatCoversTheCenter_data() {
        QTest::addColumn<Beams>("beams");
        QTest::addColumn<float>("left_m");
        QTest::addColumn<float>("right_m");
        QTest::addColumn<float>("expected_m");
        const Beams steep_ground{{-0.05, 0.0, 5.0}, {0.02, 0.0, 5.0}};
        const Beams flat_ground{{-0.05, 0.0, 0.6}, {0.02, 0.0, 0.6}};
        const auto with = [](Beams beams, const Beams& more) {
            beams.insert(beams.end(), more.begin(), more.end());
            return beams;
        };
        QTest::newRow("one floor has the mean of its hits")
            << Beams{{-0.1, 1.0, 3.0}, {0.1, 1.2, 3.0}} << 1.1f << 1.1f << 1.1f;
        QTest::newRow("steep beams see the ground before a crown")
            << with(steep_ground, {{0.1, 5.0, 1.0}, {0.11, 5.2, 1.0}}) << 0.0f << 5.0f << 0.0f;
        QTest::newRow("in whichever order they come")
            << with({{0.1, 5.0, 1.0}, {0.11, 5.2, 1.0}}, steep_ground) << 0.0f << 5.0f << 0.0f;
        QTest::newRow("flat beams see the ground below a crown")
            << with(flat_ground, {{-0.05, 5.0, 1.0}, {-0.02, 5.0, 1.0}}) << 5.0f << 5.0f << 5.0f;
        QTest::newRow("a crown that was hit only behind the center of the cell ends there")
            << Beams{{0.1, 5.0, 1.0}, {0.11, 5.1, 1.0}} << 0.0f << 5.0f << 0.0f;
        QTest::newRow("a crown that was hit before the center goes on")
            << Beams{{-0.1, 5.0, 1.0}, {-0.11, 5.0, 1.0}} << 0.0f << 5.0f << 5.0f;
    }
    void tellsWhatCoversTheCenter() {
        QFETCH(Beams, beams);
        QFETCH(float, left_m);
        QFETCH(float, right_m);
        QFETCH(float, expected_m);
        const float is_m = settled_m(beams, [&](int column) { return column < 1 ? left_m : right_m; });
        QVERIFY2(std::abs(is_m - expected_m) < 0.15f, qPrintable(QString::number(double(is_m))));
    }

    void lowersFilledCellsOnlyAtAnEdge_data() {
        QTest::addColumn<float>("left_m");
        QTest::addColumn<float>("least_m");
        QTest::addColumn<float>("most_m");
        QTest::newRow("in the midst of a crown") << 5.0f << 5.2f << 5.2f;
        QTest::newRow("at its edge") << 0.0f << 0.5f << 3.0f;
    }
    void lowersFilledCellsOnlyAtAnEdge() {
        QFETCH(float, left_m);
        QFETCH(float, least_m);
        QFETCH(float, most_m);
        const float is_m = settled_m(
            {}, [&](int column) { return column < 1 ? left_m : 5.0f; }, 5.2f);
        QVERIFY2(is_m >= least_m && is_m <= most_m, qPrintable(QString::number(double(is_m))));
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

    void isNearerToTheTruthAtAnEdgeThanTheRunningMean() {
        const ScanStore store = flyOverTheTower();
        HeightMap running_mean(cell_m);
        ScanIntegrator integrator;
        std::vector<double> ranges_m;
        for (const KeptScan& scan : store.scans()) {
            if (!scan.continues)
                integrator.breakStrip();
            integrator.integrate(scan.beams(ranges_m), scan.scanner_in_map, scan.line, running_mean);
        }
        MapRebuild rebuild(store, {}, HeightMap(cell_m));
        while (rebuild.step()) {
        }
        const double floors_m = edgeError_m(rebuild.takeMap()), mean_m = edgeError_m(running_mean);
        QVERIFY2(floors_m < 0.7 * mean_m, qPrintable(QString("%1 m, the running mean %2 m").arg(floors_m).arg(mean_m)));
    }
};

USAR_TEST(tst_CellFloors)

} // namespace tst_cell_floors

#include "tst_cell_floors.moc"
