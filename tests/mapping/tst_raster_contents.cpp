// Rasters of random maps hold what the map holds, and the rule of what is a hit.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <string>

#include <QTest>

#include "core/base/random.h"
#include "core/mapping/hit.h"
#include "core/mapping/raster_export.h"
#include "tests/suite/suite.h"

namespace tst_raster_contents {

using namespace usar;
using namespace usar::mapping;

namespace {

constexpr double cell_size_m = 0.25;

/// A map with some hundred cells around the origin, some of them written more than once.
HeightMap randomMap(std::uint64_t seed) {
    Random random = seeded(seed, 1);
    std::uniform_int_distribution<std::int32_t> place(-150, 150);
    HeightMap map(cell_size_m);
    for (int i = 0; i < 400; ++i) {
        const GridIndex cell{place(random), place(random)};
        map.write(cell, static_cast<float>(uniform(random, -20.0, 90.0)), {});
        if (i % 3 == 0)
            map.fill({cell.column + 1, cell.row}, 1.0f, {});
    }
    return map;
}

float floatAt(const std::vector<char>& bytes, std::size_t index) {
    std::uint32_t bits = 0;
    for (std::size_t i = 4; i-- > 0;)
        bits = bits << 8 | static_cast<std::uint8_t>(bytes[4 * index + i]);
    return std::bit_cast<float>(bits);
}

} // namespace

class tst_RasterContents : public QObject {
    Q_OBJECT
private slots:
    void theRawHeightsReadBack() {
        const Raster raster = rasterOf(randomMap(5));
        auto read = readBilHeader(bilHeader(raster));
        QVERIFY(read && read->empty() && takeBilBytes(*read, bilBytes(raster)));
        QCOMPARE(read->columns, raster.columns);
        QCOMPARE(read->rows, raster.rows);
        QCOMPARE(read->cell_size_m, raster.cell_size_m);
        QVERIFY(read->upper_left_center_m == raster.upper_left_center_m);
        QVERIFY(std::ranges::equal(read->heights_m, raster.heights_m,
                                   [](float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }));
    }

    void rawHeightsThatAreNotOursAreRefused_data() {
        QTest::addColumn<std::string>("word");
        QTest::addColumn<std::string>("instead");
        QTest::newRow("other byte order") << std::string("BYTEORDER      I") << std::string("BYTEORDER M");
        QTest::newRow("integers") << std::string("PIXELTYPE      FLOAT") << std::string("PIXELTYPE SIGNEDINT");
        QTest::newRow("short samples") << std::string("NBITS          32") << std::string("NBITS 16");
        QTest::newRow("no place") << std::string("ULXMAP") << std::string("OTHER");
        QTest::newRow("a size that is no number") << std::string("XDIM           0.25") << std::string("XDIM wide");
        QTest::newRow("no rows") << std::string("NROWS          1") << std::string("NROWS 0");
        QTest::newRow("more rows than bytes") << std::string("NROWS          1") << std::string("NROWS 2");
        QTest::newRow("a side without end") << std::string("NCOLS          1") << std::string("NCOLS 99999999999");
    }

    void rawHeightsThatAreNotOursAreRefused() {
        QFETCH(std::string, word);
        QFETCH(std::string, instead);
        const Raster raster{1, 1, 0.25, {0.125, 0.125}, {5.0f}};
        std::string header = bilHeader(raster);
        const std::size_t at = header.find(word);
        QVERIFY(at != std::string::npos);
        header.replace(at, word.size(), instead);
        auto read = readBilHeader(header);
        QVERIFY(!read || !takeBilBytes(*read, bilBytes(raster)));
    }

    void theAsciiGridReadsBack() {
        const Raster raster = rasterOf(randomMap(6));
        std::istringstream text(asciiGrid(raster));
        std::map<std::string, double> head;
        for (int i = 0; i < 6; ++i) {
            std::string key;
            text >> key;
            text >> head[key];
        }
        QCOMPARE(head.at("ncols"), double(raster.columns));
        QCOMPARE(head.at("nrows"), double(raster.rows));
        QCOMPARE(head.at("cellsize"), cell_size_m);
        QCOMPARE(head.at("xllcorner") + cell_size_m / 2.0, raster.upper_left_center_m.x());
        QCOMPARE(head.at("yllcorner") + (double(raster.rows) - 0.5) * cell_size_m, raster.upper_left_center_m.y());
        for (const float height_m : raster.heights_m) {
            double read_m = 0.0;
            QVERIFY(text >> read_m);
            if (std::isnan(height_m))
                QCOMPARE(read_m, head.at("NODATA_value"));
            else
                QVERIFY(std::abs(read_m - double(height_m)) < 1e-4);
        }
        double more = 0.0;
        QVERIFY(!(text >> more));
    }

    void thePointsReadBack() {
        const HeightMap map = randomMap(7);
        std::istringstream text(xyzPoints(rasterOf(map)));
        std::string names;
        std::getline(text, names);
        QCOMPARE(names, std::string("x y z"));
        std::size_t points = 0;
        double x_m = 0.0, y_m = 0.0, z_m = 0.0;
        for (; text >> x_m >> y_m >> z_m; ++points) {
            const GridIndex cell = map.cellAt({x_m, y_m});
            QVERIFY(map.height_m(cell));
            QVERIFY((map.center_m(cell) - Vec2(x_m, y_m)).norm() < 1e-9);
            QVERIFY(std::abs(double(*map.height_m(cell)) - z_m) < 1e-4);
        }
        QCOMPARE(points, map.knownCellCount());
    }

    void everyCellHasTheHeightOfTheMap_data() {
        QTest::addColumn<quint64>("seed");
        for (quint64 seed = 1; seed <= 5; ++seed)
            QTest::addRow("seed %d", int(seed)) << seed;
    }
    void everyCellHasTheHeightOfTheMap() {
        QFETCH(quint64, seed);
        const HeightMap map = randomMap(seed);
        QCOMPARE(rastersOf(map).size(), std::size_t(1));
        const Raster raster = rasterOf(map);
        QCOMPARE(raster.cell_size_m, cell_size_m);
        QCOMPARE(raster.knownCellCount(), map.knownCellCount());
        QCOMPARE(raster.heights_m.size(), static_cast<std::size_t>(raster.columns * raster.rows));
        for (std::int64_t row = 0; row < raster.rows; ++row)
            for (std::int64_t column = 0; column < raster.columns; ++column) {
                const Vec2 center_m = raster.upper_left_center_m + cell_size_m * Vec2(double(column), -double(row));
                const auto height_m = map.height_m(map.cellAt(center_m));
                const float got_m = raster.heights_m[static_cast<std::size_t>(row * raster.columns + column)];
                QCOMPARE(std::isnan(got_m), !height_m);
                if (height_m)
                    QCOMPARE(got_m, *height_m);
            }
    }

    void noBorderIsWithoutAKnownCell() {
        const Raster raster = rasterOf(randomMap(9));
        const auto known = [&](std::int64_t row, std::int64_t column) {
            return !std::isnan(raster.heights_m[static_cast<std::size_t>(row * raster.columns + column)]);
        };
        bool top = false, bottom = false, left = false, right = false;
        for (std::int64_t column = 0; column < raster.columns; ++column) {
            top = top || known(0, column);
            bottom = bottom || known(raster.rows - 1, column);
        }
        for (std::int64_t row = 0; row < raster.rows; ++row) {
            left = left || known(row, 0);
            right = right || known(row, raster.columns - 1);
        }
        QVERIFY(top && bottom && left && right);
    }

    void theRangeIsThatOfTheCells() {
        const Raster raster = rasterOf(randomMap(10));
        const std::optional<HeightRange> range = raster.range();
        QVERIFY(range);
        bool lowest = false, highest = false;
        for (const float height_m : raster.heights_m) {
            if (std::isnan(height_m))
                continue;
            QVERIFY(height_m >= range->minimum_m && height_m <= range->maximum_m);
            lowest = lowest || height_m == range->minimum_m;
            highest = highest || height_m == range->maximum_m;
        }
        QVERIFY(lowest && highest);
        QVERIFY(!Raster().range());
    }

    void rawBytesAreTheHeightsInOrder() {
        const Raster raster = rasterOf(randomMap(11));
        const std::vector<char> bytes = bilBytes(raster);
        QCOMPARE(bytes.size(), 4 * raster.heights_m.size());
        for (std::size_t i = 0; i < raster.heights_m.size(); ++i) {
            const float height_m = raster.heights_m[i];
            QCOMPARE(floatAt(bytes, i), std::isnan(height_m) ? no_data_m : height_m);
        }
    }

    void aRangeNearTheMaximumIsNoHit_data() {
        QTest::addColumn<double>("range_m");
        QTest::addColumn<double>("maximum_m");
        QTest::addColumn<bool>("hit");
        constexpr double infinity = std::numeric_limits<double>::infinity();
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("well within") << 3.0 << 20.0 << true;
        QTest::newRow("just before the margin") << 19.97 << 20.0 << true;
        QTest::newRow("within the margin") << 19.99 << 20.0 << false;
        QTest::newRow("the maximum") << 20.0 << 20.0 << false;
        QTest::newRow("beyond it") << 20.5 << 20.0 << false;
        QTest::newRow("endless") << infinity << 20.0 << false;
        QTest::newRow("without a maximum") << 1e6 << infinity << true;
        QTest::newRow("not a number") << nan << 20.0 << false;
        QTest::newRow("a maximum that is none") << 3.0 << nan << false;
    }
    void aRangeNearTheMaximumIsNoHit() {
        QFETCH(double, range_m);
        QFETCH(double, maximum_m);
        QFETCH(bool, hit);
        QCOMPARE(isHit(range_m, maximum_m), hit);
    }
};

USAR_TEST(tst_RasterContents)

} // namespace tst_raster_contents

#include "tst_raster_contents.moc"
