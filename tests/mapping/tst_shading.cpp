#include <QTest>

#include <vector>

#include "core/mapping/shading.h"
#include "tests/suite/suite.h"

namespace tst_shading {

using namespace usar::mapping;

namespace {

double luminance(std::uint32_t color) {
    return 0.2126 * (color >> 16 & 0xff) + 0.7152 * (color >> 8 & 0xff) + 0.0722 * (color & 0xff);
}

} // namespace

class tst_Shading : public QObject {
    Q_OBJECT
private slots:
    void grayRunsFromDepthToHeight_data();
    void grayRunsFromDepthToHeight();
    void higherIsNeverDarker_data();
    void higherIsNeverDarker();
    void unknownIsTransparent();
    void tilesAreTurnedUpright();
};

void tst_Shading::grayRunsFromDepthToHeight_data() {
    QTest::addColumn<float>("height_m");
    QTest::addColumn<HeightRange>("range");
    QTest::addColumn<quint32>("color");
    const HeightRange range{-10.0f, 10.0f};
    QTest::newRow("lowest is black") << -10.0f << range << 0xff000000u;
    QTest::newRow("highest is white") << 10.0f << range << 0xffffffffu;
    QTest::newRow("half way") << 0.0f << range << 0xff808080u;
    QTest::newRow("below the range") << -99.0f << range << 0xff000000u;
    QTest::newRow("above the range") << 99.0f << range << 0xffffffffu;
    QTest::newRow("level ground") << 3.0f << HeightRange{3.0f, 3.0f} << 0xff808080u;
}

void tst_Shading::grayRunsFromDepthToHeight() {
    QFETCH(float, height_m);
    QFETCH(HeightRange, range);
    QFETCH(quint32, color);
    QCOMPARE(shade(height_m, range, ColorMap::Gray), color);
}

void tst_Shading::higherIsNeverDarker_data() {
    QTest::addColumn<int>("color_map");
    QTest::newRow("gray") << int(ColorMap::Gray);
    QTest::newRow("terrain") << int(ColorMap::Terrain);
}

void tst_Shading::higherIsNeverDarker() {
    QFETCH(int, color_map);
    double last = -1.0;
    for (int i = 0; i <= 1000; ++i) {
        const std::uint32_t color = shade(float(i), {0.0f, 1000.0f}, ColorMap(color_map));
        QCOMPARE(color >> 24, 0xffu);
        QVERIFY(luminance(color) >= last);
        last = luminance(color);
    }
    QVERIFY(last > 240.0);
}

void tst_Shading::unknownIsTransparent() {
    QCOMPARE(shade(std::nanf(""), {0.0f, 1.0f}, ColorMap::Gray), 0u);
    QCOMPARE(shade(std::nanf(""), {1.0f, 1.0f}, ColorMap::Terrain), 0u);
}

void tst_Shading::tilesAreTurnedUpright() {
    HeightTile tile;
    tile.preview_m[3] = 1.0f;            // lowest row, column 3
    tile.height_m[3] = 0.0f;             // the preview is what is shown
    tile.preview_m[63 * 64 + 60] = 0.0f; // highest row
    std::vector<std::uint32_t> pixels(HeightTile::cell_count, 0x12345678u);
    shadeTile(tile, {0.0f, 1.0f}, ColorMap::Gray, pixels);
    QCOMPARE(pixels[63 * 64 + 3], 0xffffffffu);
    QCOMPARE(pixels[60], 0xff000000u);
    QCOMPARE(std::count(pixels.begin(), pixels.end(), 0u), std::ptrdiff_t(HeightTile::cell_count - 2));
}

USAR_TEST(tst_Shading)

} // namespace tst_shading

#include "tst_shading.moc"
