#include <QRectF>
#include <QTest>

#include <limits>

#include "core/mapping/height_map.h"
#include "tests/suite/suite.h"

namespace tst_height_probe {

using namespace usar;
using namespace usar::mapping;

class tst_HeightProbe : public QObject {
    Q_OBJECT
private slots:
    void findsTheCellThatCoversThePoint_data();
    void findsTheCellThatCoversThePoint();
    void tellsHowOftenItWasMeasured();
    void tellsTheLineThatWroteItLast();
    void theRangeOfARectangleIsThatOfItsCells_data();
    void theRangeOfARectangleIsThatOfItsCells();
};

HeightTiles tilesOf(HeightMap& map) {
    HeightTiles tiles;
    for (const auto& tile : map.takeChangedTiles())
        tiles[tile->index] = tile;
    return tiles;
}

/// One measured cell with 4.25 m: x in [-0.25, 0), y in [0.5, 0.75).
HeightTiles oneCell() {
    HeightMap map(0.25);
    map.write({-1, 2}, 4.25f, {});
    return tilesOf(map);
}

void tst_HeightProbe::findsTheCellThatCoversThePoint_data() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    QTest::addColumn<double>("x_m");
    QTest::addColumn<double>("y_m");
    QTest::addColumn<bool>("known");
    QTest::newRow("inside") << -0.1 << 0.6 << true;
    QTest::newRow("at its lowest corner") << -0.25 << 0.5 << true;
    QTest::newRow("beside it") << -0.3 << 0.6 << false;
    QTest::newRow("in a tile that is not there") << 0.1 << 0.6 << false;
    QTest::newRow("far away") << 1e12 << 0.0 << false;
    QTest::newRow("nowhere") << infinity << std::numeric_limits<double>::quiet_NaN() << false;
}

void tst_HeightProbe::findsTheCellThatCoversThePoint() {
    QFETCH(double, x_m);
    QFETCH(double, y_m);
    QFETCH(bool, known);
    const auto probe = probeHeight(oneCell(), 0.25, Vec2(x_m, y_m));
    QCOMPARE(probe.has_value(), known);
    if (known)
        QCOMPARE(probe->height_m, 4.25f);
}

void tst_HeightProbe::tellsHowOftenItWasMeasured() {
    QCOMPARE(probeHeight(oneCell(), 0.25, Vec2(-0.1, 0.6))->hits, 1);
    QVERIFY(!probeHeight({}, 0.25, Vec2(-0.1, 0.6)));
}

void tst_HeightProbe::tellsTheLineThatWroteItLast() {
    HeightMap map(0.25);
    map.write({0, 0}, 1.0f, {7});
    map.write({0, 0}, 2.0f, {41});
    map.fill({1, 0}, 1.5f, {42});
    const HeightTiles tiles = tilesOf(map);
    QCOMPARE(probeHeight(tiles, 0.25, Vec2(0.1, 0.1))->line.value, std::uint64_t(41));
    QCOMPARE(probeHeight(tiles, 0.25, Vec2(0.3, 0.1))->line.value, std::uint64_t(42));
}

void tst_HeightProbe::theRangeOfARectangleIsThatOfItsCells_data() {
    QTest::addColumn<QRectF>("area_m");
    QTest::addColumn<QList<float>>("range_m"); // empty: nothing is known
    QTest::newRow("one cell") << QRectF(-0.2, -0.2, 0.1, 0.1) << QList<float>{-3.0f, -3.0f};
    QTest::newRow("across four tiles") << QRectF(-0.2, -0.2, 0.4, 0.4) << QList<float>{-3.0f, 5.0f};
    QTest::newRow("cells at the edge count whole") << QRectF(0.2, 0.2, 14.9, 0.1) << QList<float>{5.0f, 5.0f};
    QTest::newRow("the last cell of a tile") << QRectF(0.2, 0.2, 15.7, 0.1) << QList<float>{5.0f, 8.0f};
    QTest::newRow("everything") << QRectF(-1e12, -1e12, 2e12, 2e12) << QList<float>{-3.0f, 8.0f};
    QTest::newRow("beside all") << QRectF(1.0, 1.0, 3.0, 3.0) << QList<float>{};
    QTest::newRow("beside all tiles") << QRectF(100.0, 100.0, 3.0, 3.0) << QList<float>{};
}

void tst_HeightProbe::theRangeOfARectangleIsThatOfItsCells() {
    QFETCH(QRectF, area_m);
    QFETCH(QList<float>, range_m);
    HeightMap map(0.25);
    map.write({-1, -1}, -3.0f, {1}); // Each in a tile of its own but the last two.
    map.write({-1, 0}, 1.0f, {1});
    map.write({0, -1}, 2.0f, {1});
    map.write({0, 0}, 5.0f, {1});
    map.write({63, 0}, 8.0f, {1});
    const auto range =
        rangeWithin(tilesOf(map), 0.25, {{area_m.left(), area_m.top()}, {area_m.right(), area_m.bottom()}});
    QCOMPARE(range.has_value(), !range_m.isEmpty());
    if (range)
        QCOMPARE(*range, (HeightRange{range_m[0], range_m[1]}));
}

USAR_TEST(tst_HeightProbe)

} // namespace tst_height_probe

#include "tst_height_probe.moc"
