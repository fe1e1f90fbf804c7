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
};

/// One measured cell with 4.25 m: x in [-0.25, 0), y in [0.5, 0.75).
HeightTiles oneCell() {
    HeightMap map(0.25);
    map.write({-1, 2}, 4.25f, {});
    HeightTiles tiles;
    for (const auto& tile : map.takeChangedTiles())
        tiles[tile->index] = tile;
    return tiles;
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

USAR_TEST(tst_HeightProbe)

} // namespace tst_height_probe

#include "tst_height_probe.moc"
