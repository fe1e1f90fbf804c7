#include <cmath>
#include <limits>

#include <QTest>

#include "core/mapping/raster_difference.h"
#include "tests/suite/suite.h"

namespace tst_raster_difference {

using namespace usar;
using namespace usar::mapping;

namespace {

constexpr float nan_m = std::numeric_limits<float>::quiet_NaN();

Raster raster(std::int64_t columns, const Vec2& upper_left_m, const std::vector<float>& heights_m,
              double cell_size_m = 0.5) {
    return {columns, static_cast<std::int64_t>(heights_m.size()) / columns, cell_size_m, upper_left_m, heights_m};
}

} // namespace

/// Two maps are laid over each other by their places, not by their rows.
class tst_RasterDifference : public QObject {
    Q_OBJECT
private slots:
    void cellsAreComparedWhereTheyLie() {
        const Raster first = raster(2, {0.25, 0.75}, {1.0f, 2.0f, 3.0f, nan_m});
        const Raster second = raster(2, {0.75, 0.25}, {7.0f, 8.0f, 9.0f, 10.0f}); // One cell to the right and down.
        const auto difference = differenceOf(first, second);
        QVERIFY(difference);
        const Raster& raster = difference->second_minus_first;
        QCOMPARE(raster.columns, 3);
        QCOMPARE(raster.rows, 3);
        QCOMPARE(raster.upper_left_center_m.x(), 0.25);
        QCOMPARE(raster.upper_left_center_m.y(), 0.75);
        QCOMPARE(raster.knownCellCount(), std::size_t(0)); // The only shared cell is unknown in the first.
        QCOMPARE(difference->only_first, std::size_t(3));
        QCOMPARE(difference->only_second, std::size_t(4));
    }

    void figuresAreThoseOfTheSharedCells() {
        const Raster first = raster(3, {0.25, 0.25}, {1.0f, 2.0f, 3.0f});
        const Raster second = raster(3, {0.25, 0.25}, {2.0f, nan_m, 0.0f});
        const auto difference = differenceOf(first, second);
        QVERIFY(difference);
        QCOMPARE(difference->in_both, std::size_t(2));
        QCOMPARE(difference->only_first, std::size_t(1));
        QCOMPARE(difference->only_second, std::size_t(0));
        QCOMPARE(difference->mean_m, -1.0);
        QCOMPARE(difference->rms_m, std::sqrt(5.0));
        QCOMPARE(difference->largest_m, 3.0);
        QCOMPARE(difference->second_minus_first.heights_m[0], 1.0f);
        QCOMPARE(difference->second_minus_first.heights_m[2], -3.0f);
        QVERIFY(std::isnan(difference->second_minus_first.heights_m[1]));
    }

    void aMapDoesNotDifferFromItself() {
        const Raster map = raster(2, {-16.125, 20.875}, {1.0f, nan_m, 3.0f, 4.0f}, 0.25);
        const auto difference = differenceOf(map, map);
        QVERIFY(difference);
        QCOMPARE(difference->in_both, std::size_t(3));
        QCOMPARE(difference->rms_m, 0.0);
        QCOMPARE(difference->only_first + difference->only_second, std::size_t(0));
    }

    void mapsThatCannotBeComparedHaveNoDifference_data() {
        QTest::addColumn<double>("cell_size_m");
        QTest::addColumn<double>("x_m");
        QTest::newRow("other cells") << 0.25 << 0.25;
        QTest::newRow("too far away") << 0.5 << 1e5;
    }

    void mapsThatCannotBeComparedHaveNoDifference() {
        QFETCH(double, cell_size_m);
        QFETCH(double, x_m);
        const Raster first = raster(1, {0.25, 0.25}, {1.0f});
        QVERIFY(!differenceOf(first, raster(1, {x_m, 0.25}, {1.0f}, cell_size_m)));
        QVERIFY(!differenceOf(first, Raster{}));
    }
};

USAR_TEST(tst_RasterDifference)

} // namespace tst_raster_difference

#include "tst_raster_difference.moc"
