#include <QTest>

#include "core/mapping/area_cells.h"
#include "core/mission/runs/mission_score.h"
#include "tests/suite/suite.h"

namespace tst_area_cells {

using namespace usar;
using namespace usar::mission;

class tst_AreaCells : public QObject {
    Q_OBJECT
private slots:
    void countsCellsWhoseCentersAreInside_data() {
        QTest::addColumn<Rectangle>("area");
        QTest::addColumn<int>("columns");
        QTest::addColumn<int>("rows");
        QTest::newRow("on the edges of cells") << Rectangle{{-10, -5}, {10, 5}} << 40 << 20;
        QTest::newRow("one cell") << Rectangle{{0, 0}, {0.5, 0.5}} << 1 << 1;
        QTest::newRow("edges on centers: the lower one counts") << Rectangle{{0.25, 0.25}, {1.25, 0.75}} << 2 << 1;
        QTest::newRow("between centers") << Rectangle{{0.3, 0.3}, {0.7, 5}} << 0 << 9;
        QTest::newRow("no area") << Rectangle{} << 0 << 0;
    }

    void countsCellsWhoseCentersAreInside() {
        QFETCH(Rectangle, area);
        QFETCH(int, columns);
        QFETCH(int, rows);
        const mapping::AreaCells cells = mapping::cellsOf(area, 0.5);
        QCOMPARE(int(cells.columns.count()), columns);
        QCOMPARE(int(cells.rows.count()), rows);
        QCOMPARE(int(cells.count()), columns * rows);
    }

    void tilesCoverAsMuchAsTheRasterOfTheSameMap_data() {
        QTest::addColumn<Rectangle>("area");
        QTest::newRow("within a tile") << Rectangle{{1, 2}, {9, 7}};
        QTest::newRow("over four tiles") << Rectangle{{-10, -5}, {10, 5}};
        QTest::newRow("over tiles that are not there") << Rectangle{{-100, -5}, {100, 5}};
        QTest::newRow("askew to the cells") << Rectangle{{-3.33, -2.1}, {4.77, 6.6}};
        QTest::newRow("elsewhere") << Rectangle{{200, 200}, {210, 210}};
    }

    void tilesCoverAsMuchAsTheRasterOfTheSameMap() {
        QFETCH(Rectangle, area);
        mapping::HeightMap map(0.25);
        for (double x = -20.0; x < 20.0; x += 0.5) // every second column
            for (double y = -20.0; y < 3.0; y += 0.25)
                map.write(map.cellAt({x + 0.1, y + 0.1}), 1.0f, {1});
        const mapping::AreaCells cells = mapping::cellsOf(area, map.cellSize_m());
        int known = 0;
        for (const auto& tile : map.takeChangedTiles())
            known += mapping::knownCellsIn(cells, *tile);
        QCOMPARE(100.0 * known / double(cells.count()), score(mapping::rasterOf(map), area, nullptr).coverage_pct);
    }
};

USAR_TEST(tst_AreaCells)

} // namespace tst_area_cells

#include "tst_area_cells.moc"
