#include <QTest>

#include "core/base/random.h"
#include "core/mapping/area_cells.h"
#include "core/mission/runs/remaining_area.h"
#include "tests/suite/suite.h"

namespace tst_remaining_area {

using namespace usar;
using namespace usar::mission;

namespace {

constexpr double cell_m = 0.5;

mapping::HeightTiles tilesOf(mapping::HeightMap& map) {
    mapping::HeightTiles tiles;
    for (const auto& tile : map.takeChangedTiles())
        tiles[tile->index] = tile;
    return tiles;
}

/// Makes every cell known whose center is in the rectangle.
void scan(mapping::HeightMap& map, const Rectangle& where) {
    const mapping::AreaCells cells = mapping::cellsOf(where, map.cellSize_m());
    for (std::int64_t row = cells.rows.first; row <= cells.rows.last; ++row)
        for (std::int64_t column = cells.columns.first; column <= cells.columns.last; ++column)
            map.write({std::int32_t(column), std::int32_t(row)}, 1.0f, {1});
}

/// Centers of the unknown cells of the area.
std::vector<Vec2> unknownIn(const Rectangle& area, const mapping::HeightMap& map) {
    std::vector<Vec2> centers_m;
    const mapping::AreaCells cells = mapping::cellsOf(area, map.cellSize_m());
    for (std::int64_t row = cells.rows.first; row <= cells.rows.last; ++row)
        for (std::int64_t column = cells.columns.first; column <= cells.columns.last; ++column) {
            const mapping::GridIndex cell{std::int32_t(column), std::int32_t(row)};
            if (!map.height_m(cell))
                centers_m.push_back(map.center_m(cell));
        }
    return centers_m;
}

} // namespace

class tst_RemainingArea : public QObject {
    Q_OBJECT
private slots:
    void isWhatTheLanesHaveNotReached_data() {
        QTest::addColumn<std::vector<Rectangle>>("scanned");
        QTest::addColumn<Rectangle>("rest");
        using Scans = std::vector<Rectangle>;
        QTest::newRow("nothing was scanned") << Scans{} << Rectangle{{-20, -10}, {20, 10}};
        QTest::newRow("elsewhere was scanned") << Scans{{{100, 100}, {130, 130}}} << Rectangle{{-20, -10}, {20, 10}};
        QTest::newRow("the lower half") << Scans{{{-20, -10}, {20, 0}}} << Rectangle{{-20, 0}, {20, 10}};
        QTest::newRow("more than the lower half") << Scans{{{-25, -15}, {25, 3}}} << Rectangle{{-20, 3}, {20, 10}};
        QTest::newRow("the left part") << Scans{{{-20, -10}, {5, 10}}} << Rectangle{{5, -10}, {20, 10}};
        QTest::newRow("both ends") << Scans{{{-20, -10}, {-8, 10}}, {{9, -10}, {20, 10}}}
                                   << Rectangle{{-8, -10}, {9, 10}};
        QTest::newRow("one lane and a half")
            << Scans{{{-20, -10}, {20, -4}}, {{3, -4}, {20, 2}}} << Rectangle{{-20, -4}, {20, 10}};
        QTest::newRow("all of it") << Scans{{{-20, -10}, {20, 10}}} << Rectangle{};
        QTest::newRow("all but a shadow")
            << Scans{{{-20, -10}, {20, 5}}, {{-20, 5}, {5, 10}}, {{7, 5}, {20, 10}}} << Rectangle{};
    }

    void isWhatTheLanesHaveNotReached() {
        QFETCH(std::vector<Rectangle>, scanned);
        QFETCH(Rectangle, rest);
        mapping::HeightMap map(cell_m);
        for (const Rectangle& where : scanned)
            scan(map, where);
        QCOMPARE(remainingArea({{-20, -10}, {20, 10}}, tilesOf(map), cell_m), rest);
    }

    void withoutAnAreaNothingRemains() {
        mapping::HeightMap map(cell_m);
        QVERIFY(remainingArea({}, tilesOf(map), cell_m).empty());
        QVERIFY(remainingArea({{0.1, 0.1}, {0.2, 0.2}}, tilesOf(map), cell_m).empty()); // No cell's center is in it.
    }

    /// With no gap left out, the rectangle holds every unknown cell, and each of its sides touches one.
    void everyUnknownCellLiesInIt() {
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            Random random = seeded(seed, 5);
            const Vec2 low_m(uniform(random, -60, 60), uniform(random, -60, 60));
            const Rectangle area{low_m, low_m + Vec2(uniform(random, 1, 40), uniform(random, 1, 40))};
            mapping::HeightMap map(cell_m);
            for (int piece = 0; piece < int(seed % 7); ++piece) {
                const Vec2 corner_m(uniform(random, low_m.x() - 5, area.max_m.x()),
                                    uniform(random, low_m.y() - 5, area.max_m.y()));
                scan(map, {corner_m, corner_m + Vec2(uniform(random, 1, 40), uniform(random, 1, 40))});
            }
            const std::vector<Vec2> unknown_m = unknownIn(area, map);
            const mapping::HeightTiles tiles = tilesOf(map);
            const Rectangle rest = remainingArea(area, tiles, cell_m, 0.0);
            QCOMPARE(rest.empty(), unknown_m.empty());
            Rectangle tight{{1e9, 1e9}, {-1e9, -1e9}};
            for (const Vec2& point_m : unknown_m) {
                QVERIFY2(rest.contains(point_m), qPrintable(QString("seed %1").arg(seed)));
                tight.min_m = tight.min_m.cwiseMin(point_m);
                tight.max_m = tight.max_m.cwiseMax(point_m);
            }
            if (unknown_m.empty())
                continue;
            QVERIFY(area.contains(rest));
            QVERIFY((tight.min_m - rest.min_m).maxCoeff() <= cell_m && (rest.max_m - tight.max_m).maxCoeff() <= cell_m);
            const Rectangle usual = remainingArea(area, tiles, cell_m);
            QVERIFY(usual.empty() || rest.contains(usual));
        }
    }

    void aGapCountsFromItsSizeOn_data() {
        QTest::addColumn<double>("largest_gap_m2");
        QTest::addColumn<bool>("left");
        QTest::newRow("smaller than what may stay") << 4.5 << false;
        QTest::newRow("as large as what may stay") << 4.0 << false;
        QTest::newRow("larger") << 3.75 << true;
    }

    void aGapCountsFromItsSizeOn() {
        QFETCH(double, largest_gap_m2);
        QFETCH(bool, left);
        mapping::HeightMap map(cell_m);
        const Rectangle area{{0, 0}, {10, 10}};
        const Rectangle gap{{4, 4}, {6, 6}};
        for (const Rectangle& around : {Rectangle{{0, 0}, {10, 4}}, Rectangle{{0, 6}, {10, 10}},
                                        Rectangle{{0, 4}, {4, 6}}, Rectangle{{6, 4}, {10, 6}}})
            scan(map, around);
        QCOMPARE(remainingArea(area, tilesOf(map), cell_m, largest_gap_m2), left ? gap : Rectangle{});
    }
};

USAR_TEST(tst_RemainingArea)

} // namespace tst_remaining_area

#include "tst_remaining_area.moc"
