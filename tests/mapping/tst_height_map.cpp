#include <QTest>

#include <limits>

#include "core/mapping/height_map.h"
#include "core/mapping/raster_export.h"
#include "tests/suite/suite.h"

namespace tst_height_map {

using namespace usar;
using namespace usar::mapping;

class tst_HeightMap : public QObject {
    Q_OBJECT
private slots:
    void pointsFallIntoTheCellThatCoversThem_data();
    void pointsFallIntoTheCellThatCoversThem();
    void farPointsStayOnTheGrid();
    void secondValueMakesTheMeanAndThePreviewIsNewest();
    void measuredHeightReplacesAFilledOne();
    void fillNeverTouchesAMeasuredCell();
    void ignoresHeightsThatAreNotFinite_data();
    void ignoresHeightsThatAreNotFinite();
    void growsInEveryDirection();
    void rangeIsThatOfTheCellsThereAre();
    void changedTilesComeOnceAndAsCopies();
    void remembersTheLineThatWroteLast();
    void hitsSaturate();
    void memoryGrowsByTileNotByExtent();
};

void tst_HeightMap::pointsFallIntoTheCellThatCoversThem_data() {
    QTest::addColumn<double>("x_m");
    QTest::addColumn<double>("y_m");
    QTest::addColumn<int>("column");
    QTest::addColumn<int>("row");
    QTest::newRow("origin") << 0.0 << 0.0 << 0 << 0;
    QTest::newRow("inside") << 0.49 << 0.26 << 1 << 1;
    QTest::newRow("lower border belongs to the cell") << 0.5 << 0.25 << 2 << 1;
    QTest::newRow("just below zero") << -0.01 << -0.26 << -1 << -2;
    QTest::newRow("other side of a tile") << 16.1 << -16.1 << 64 << -65;
}

void tst_HeightMap::pointsFallIntoTheCellThatCoversThem() {
    QFETCH(double, x_m);
    QFETCH(double, y_m);
    QFETCH(int, column);
    QFETCH(int, row);
    const HeightMap map(0.25);
    const GridIndex cell = map.cellAt({x_m, y_m});
    QCOMPARE(cell.column, column);
    QCOMPARE(cell.row, row);
    QVERIFY(((map.center_m(cell) - Vec2(x_m, y_m)).cwiseAbs().array() <= 0.125 + 1e-12).all());
}

void tst_HeightMap::farPointsStayOnTheGrid() {
    const HeightMap map(0.1);
    QVERIFY(map.cellAt({1e300, -1e300}) == (GridIndex{1 << 30, -(1 << 30)}));
    QVERIFY(map.cellAt({std::nan(""), 0.0}) == (GridIndex{-(1 << 30), 0}));
}

void tst_HeightMap::secondValueMakesTheMeanAndThePreviewIsNewest() {
    HeightMap map(0.25);
    const GridIndex cell{-3, 70};
    QVERIFY(!map.height_m(cell));
    map.write(cell, 2.0f, {1});
    QCOMPARE(map.height_m(cell).value(), 2.0f);
    map.write(cell, 4.0f, {2});
    QCOMPARE(map.height_m(cell).value(), 3.0f);
    QCOMPARE(map.preview_m(cell).value(), 4.0f);
    map.write(cell, 5.0f, {3});
    QCOMPARE(map.height_m(cell).value(), 4.0f); // mean of the old and the new, not of all three
    QCOMPARE(map.preview_m(cell).value(), 5.0f);
    QCOMPARE(map.hits(cell), 3);
    QCOMPARE(map.knownCellCount(), std::size_t(1));
}

void tst_HeightMap::measuredHeightReplacesAFilledOne() {
    HeightMap map(0.25);
    map.fill({0, 0}, 1.0f, {1});
    map.fill({0, 0}, 2.0f, {1});
    QCOMPARE(map.height_m({0, 0}).value(), 1.5f);
    QCOMPARE(map.hits({0, 0}), 0);
    map.write({0, 0}, 7.0f, {2});
    QCOMPARE(map.height_m({0, 0}).value(), 7.0f);
    QCOMPARE(map.hits({0, 0}), 1);
    QCOMPARE(map.knownCellCount(), std::size_t(1));
}

void tst_HeightMap::fillNeverTouchesAMeasuredCell() {
    HeightMap map(0.25);
    map.write({5, 5}, 3.0f, {1});
    map.fill({5, 5}, 9.0f, {2});
    QCOMPARE(map.height_m({5, 5}).value(), 3.0f);
    QCOMPARE(map.preview_m({5, 5}).value(), 3.0f);
    QVERIFY(map.line({5, 5}) == LineNumber{1});
    QVERIFY(map.range() == (HeightRange{3.0f, 3.0f}));
}

void tst_HeightMap::ignoresHeightsThatAreNotFinite_data() {
    QTest::addColumn<float>("height_m");
    QTest::newRow("not a number") << std::numeric_limits<float>::quiet_NaN();
    QTest::newRow("infinity") << std::numeric_limits<float>::infinity();
    QTest::newRow("minus infinity") << -std::numeric_limits<float>::infinity();
}

void tst_HeightMap::ignoresHeightsThatAreNotFinite() {
    QFETCH(float, height_m);
    HeightMap map(0.25);
    map.write({0, 0}, height_m, {1});
    map.fill({1, 0}, height_m, {1});
    QCOMPARE(map.knownCellCount(), std::size_t(0));
    QCOMPARE(map.tileCount(), std::size_t(0));
    QVERIFY(!map.range() && !map.bounds());
}

void tst_HeightMap::growsInEveryDirection() {
    HeightMap map(0.1);
    const std::vector<GridIndex> corners{{-10000, -3}, {10000, 5}, {7, -20000}, {8, 20000}};
    for (std::size_t i = 0; i < corners.size(); ++i)
        map.write(corners[i], float(i), {i});
    for (std::size_t i = 0; i < corners.size(); ++i)
        QCOMPARE(map.height_m(corners[i]).value(), float(i));
    QVERIFY(!map.height_m({0, 0}));
    QCOMPARE(map.tileCount(), std::size_t(4));
    const CellBounds bounds = map.bounds().value();
    for (const GridIndex& cell : corners) {
        QVERIFY(bounds.first.column <= cell.column && cell.column <= bounds.last.column);
        QVERIFY(bounds.first.row <= cell.row && cell.row <= bounds.last.row);
    }
    QCOMPARE(bounds.columns() % HeightTile::side, 0);
    QCOMPARE(bounds.rows() % HeightTile::side, 0);
}

/// Legend, picture and JSON of a scan tell one range.
void tst_HeightMap::rangeIsThatOfTheCellsThereAre() {
    HeightMap map(0.25);
    map.write({0, 0}, 10.0f, {1});
    QVERIFY(map.range() == (HeightRange{10.0f, 10.0f}));
    map.write({0, 0}, -4.0f, {2}); // The cell is 3 now; no cell has either height.
    QVERIFY(map.range() == (HeightRange{3.0f, 3.0f}));
    map.fill({1, 0}, 3.5f, {3});
    map.write({500, 0}, -1.0f, {4});
    QVERIFY(map.range() == (HeightRange{-1.0f, 3.5f}));
    QVERIFY(map.range() == rasterOf(map).range());
    map.write({500, 0}, 1.0f, {5});
    QVERIFY(map.range() == (HeightRange{0.0f, 3.5f}));
}

void tst_HeightMap::changedTilesComeOnceAndAsCopies() {
    HeightMap map(0.25);
    map.write({1, 2}, 1.0f, {1});
    map.write({100, 2}, 2.0f, {1});
    map.write({3, 2}, 3.0f, {1});
    const auto first = map.takeChangedTiles();
    QCOMPARE(first.size(), std::size_t(2));
    QVERIFY(map.takeChangedTiles().empty());
    map.write({1, 2}, 5.0f, {2});
    QCOMPARE(first[0]->height_m[2 * 64 + 1], 1.0f); // what was handed out stays as it was
    const auto second = map.takeChangedTiles();
    QCOMPARE(second.size(), std::size_t(1));
    QVERIFY(second[0]->index == (GridIndex{0, 0}));
    QCOMPARE(second[0]->preview_m[2 * 64 + 1], 5.0f);
    map.fill({1, 2}, 9.0f, {3}); // changes nothing, so nothing is handed out
    QVERIFY(map.takeChangedTiles().empty());
}

void tst_HeightMap::remembersTheLineThatWroteLast() {
    HeightMap map(0.25);
    map.write({0, 0}, 1.0f, {7});
    map.fill({1, 0}, 1.0f, {8});
    map.write({0, 0}, 1.0f, {9});
    QVERIFY(map.line({0, 0}) == LineNumber{9});
    QVERIFY(map.line({1, 0}) == LineNumber{8});
    QVERIFY(map.line({2, 0}) == LineNumber{});
    QVERIFY(map.line({900, 900}) == LineNumber{});
}

void tst_HeightMap::hitsSaturate() {
    HeightMap map(0.25);
    for (int i = 0; i < 70000; ++i)
        map.write({0, 0}, 1.0f, {1});
    QCOMPARE(map.hits({0, 0}), 65535);
    map.write({0, 0}, 3.0f, {1});
    QCOMPARE(map.height_m({0, 0}).value(), 2.0f);
}

void tst_HeightMap::memoryGrowsByTileNotByExtent() {
    HeightMap map(0.25);
    map.write({0, 0}, 1.0f, {1});
    const std::size_t one_tile = map.memoryBytes();
    map.write({1'000'000, 1'000'000}, 1.0f, {1});
    QVERIFY(map.memoryBytes() < 3 * one_tile);
    QVERIFY(one_tile > sizeof(HeightTile));
    QCOMPARE(map.tileIndices().size(), map.tileCount());
}

USAR_TEST(tst_HeightMap)

} // namespace tst_height_map

#include "tst_height_map.moc"
