#include <QTest>

#include <cmath>
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
    void colorsRunFromBlueToYellow();
    void slopesTowardTheUpperLeftAreLight();
    void levelAndLonelyCellsHaveTheColorOfTheLegend();
    void contoursPassWhereALevelIsCrossed();
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
    QTest::newRow("color") << int(ColorMap::Color);
}

void tst_Shading::higherIsNeverDarker() {
    QFETCH(int, color_map);
    double last = -1.0;
    for (int i = 0; i <= 1000; ++i) {
        const std::uint32_t color = shade(float(i), {0.0f, 1000.0f}, ColorMap(color_map));
        QCOMPARE(color >> 24, 0xffu);
        QVERIFY(luminance(color) >= last - 1.0); // Each channel is rounded.
        last = luminance(color);
    }
    QVERIFY(last > 220.0);
}

void tst_Shading::unknownIsTransparent() {
    QCOMPARE(shade(std::nanf(""), {0.0f, 1.0f}, ColorMap::Gray), 0u);
    QCOMPARE(shade(std::nanf(""), {1.0f, 1.0f}, ColorMap::Color), 0u);
}

/// The colors are told apart by people who do not see red or do not see green: blue against yellow carries the height.
void tst_Shading::colorsRunFromBlueToYellow() {
    const auto blueness = [](float part) {
        const std::uint32_t color = shade(part, {0.0f, 1.0f}, ColorMap::Color);
        return int(color & 0xff) - int(color >> 16 & 0xff);
    };
    QVERIFY(blueness(0.0f) > 50);
    QVERIFY(blueness(1.0f) < -150);
    for (int i = 20; i < 100; ++i)
        QVERIFY(blueness(float(i + 1) / 100.0f) <= blueness(float(i) / 100.0f) + 1);
}

void tst_Shading::slopesTowardTheUpperLeftAreLight() {
    const HeightRange range{-10.0f, 10.0f};
    // Rises to the right and downward, so it faces the upper left; the last column falls again.
    const std::vector<float> heights_m{-0.2f, -0.1f, 0.0f, -0.1f, -0.1f, 0.0f, 0.1f, 0.0f, 0.0f, 0.1f, 0.2f, 0.1f};
    const HeightGrid grid{heights_m, 4, 3, 0.25};
    const double level = luminance(shade(0.0f, range, ColorMap::Color));
    QVERIFY(luminance(shadeCell(grid, 1, 1, range, ColorMap::Color)) > level + 5.0);
    const std::vector<float> turned(heights_m.rbegin(), heights_m.rend());
    QVERIFY(luminance(shadeCell({turned, 4, 3, 0.25}, 2, 1, range, ColorMap::Color)) < level - 5.0);
    QCOMPARE(shadeCell(grid, 1, 1, range, ColorMap::Gray), shade(0.0f, range, ColorMap::Gray));
}

void tst_Shading::levelAndLonelyCellsHaveTheColorOfTheLegend() {
    const HeightRange range{0.0f, 4.0f};
    const float unknown = std::nanf("");
    const std::vector<float> heights_m{3.0f, 3.0f, unknown, 1.0f};
    const HeightGrid grid{heights_m, 4, 1, 0.25};
    QCOMPARE(shadeCell(grid, 0, 0, range, ColorMap::Color), shade(3.0f, range, ColorMap::Color));
    QCOMPARE(shadeCell(grid, 3, 0, range, ColorMap::Color), shade(1.0f, range, ColorMap::Color));
    QCOMPARE(shadeCell(grid, 2, 0, range, ColorMap::Color), 0u);
    QCOMPARE(shadeCell(grid, 4, 0, range, ColorMap::Color), 0u);
}

void tst_Shading::contoursPassWhereALevelIsCrossed() {
    const HeightRange range{0.0f, 4.0f};
    const float unknown = std::nanf("");
    const std::vector<float> heights_m{0.2f, 0.8f, 1.2f, 1.9f, 3.1f, unknown};
    const HeightGrid grid{heights_m, 6, 1, 0.25};
    const std::vector<bool> passes{false, false, true, false, true, false};
    for (std::int64_t column = 0; column < 6; ++column)
        QCOMPARE(contourCell(grid, column, 0, range, 1.0) != 0, passes[std::size_t(column)]);
    QVERIFY2((contourCell(grid, 2, 0, range, 1.0) & 0xffffff) == 0xffffff, "light on low ground");
    QVERIFY2((contourCell(grid, 4, 0, range, 1.0) & 0xffffff) == 0, "dark on high ground");
}

USAR_TEST(tst_Shading)

} // namespace tst_shading

#include "tst_shading.moc"
