#include <cmath>
#include <random>

#include <QSignalSpy>
#include <QTest>

#include "core/mapping/shading.h"
#include "tests/suite/suite.h"
#include "widgets/map/height_layer.h"

namespace tst_height_layer {

using namespace usar;
using namespace usar::mapping;
using namespace usar::widgets;

namespace {

/// One known cell in a tile.
std::shared_ptr<const HeightTile> tileWith(GridIndex index, int column, int row, float height_m) {
    auto tile = std::make_shared<HeightTile>();
    tile->index = index;
    const auto at = static_cast<std::size_t>(row * HeightTile::side + column);
    tile->height_m[at] = tile->preview_m[at] = height_m;
    tile->hits[at] = 7;
    return tile;
}

/// Ground that rises from 0 to 6.3 m, with one cell of another height.
std::shared_ptr<const HeightTile> slopeWith(GridIndex index, float outlier_m) {
    auto tile = std::make_shared<HeightTile>();
    tile->index = index;
    for (std::size_t i = 0; i < HeightTile::cell_count; ++i)
        tile->preview_m[i] = static_cast<float>(i % HeightTile::side) * 0.1f;
    tile->preview_m[0] = outlier_m;
    return tile;
}

void settle(HeightLayer& layer) {
    QSignalSpy changed(&layer, &HeightLayer::changed);
    while (layer.busy())
        QVERIFY(changed.wait());
}

} // namespace

class tst_HeightLayer : public QObject {
    Q_OBJECT
private slots:
    void pagesHoldFourTilesASide_data();
    void pagesHoldFourTilesASide();
    void cellLandsOnItsPixel_data();
    void cellLandsOnItsPixel();
    void aPartRenderedAgainIsThatOfTheWholePage_data();
    void aPartRenderedAgainIsThatOfTheWholePage();
    void coarseLevelsAverage();
    void levelFollowsTheScale();
    void picturesAppearTogether();
    void newRangeRecolorsEverything();
    void unseenChangesOfTheRangeRecolorNothing();
    void grayAndAFixedRangeAreOneCallAway();
    void oneTreeDoesNotTakeTheColors();
    void theRangeWithoutTreesIsFoundAtMostOnceASecond();
    void contoursAreDrawnOnRequest();
    void lightComesFromTheUpperLeftOfTheScreen_data();
    void lightComesFromTheUpperLeftOfTheScreen();
    void waitsForARange();
    void clearForgetsWhatIsStillRendered();
    void probeKnowsHeightAndHits();
    void boundsCoverAllTiles();
};

void tst_HeightLayer::pagesHoldFourTilesASide_data() {
    QTest::addColumn<int>("tile");
    QTest::addColumn<int>("page");
    QTest::newRow("first") << 0 << 0;
    QTest::newRow("last of the first page") << 3 << 0;
    QTest::newRow("second page") << 4 << 1;
    QTest::newRow("left of zero") << -1 << -1;
    QTest::newRow("a whole page left") << -4 << -1;
    QTest::newRow("beyond that") << -5 << -2;
}

void tst_HeightLayer::pagesHoldFourTilesASide() {
    QFETCH(int, tile);
    QFETCH(int, page);
    QCOMPARE(pageOfTile({tile, -tile - 1}).column, page);
}

void tst_HeightLayer::cellLandsOnItsPixel_data() {
    QTest::addColumn<MapOrientation>("orientation");
    QTest::newRow("x up") << MapOrientation::XUp;
    QTest::newRow("y up") << MapOrientation::YUp;
}

/// Where the transform puts a cell's ground, the picture has its pixel.
void tst_HeightLayer::cellLandsOnItsPixel() {
    QFETCH(MapOrientation, orientation);
    PageTiles page;
    page.tiles[2 + 1 * 4] = tileWith({2, 1}, 5, 9, 3.0f);
    const QImage image = renderPage(page, {{0.0f, 4.0f}, orientation}).levels[0];
    MapTransform t;
    t.orientation = orientation;
    t.pixels_per_m = 1.0;
    const QPointF corner = t.toScreen(pageRectangle({0, 0}, 1.0)).topLeft();
    const QPointF at = t.toScreen(Vec2(2 * 64 + 5 + 0.5, 64 + 9 + 0.5)) - corner;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            QCOMPARE(qAlpha(image.pixel(x, y)) != 0, x == int(at.x()) && y == int(at.y()));
}

void tst_HeightLayer::aPartRenderedAgainIsThatOfTheWholePage_data() {
    cellLandsOnItsPixel_data();
}

/// Light, contours and reductions reach over the edges of tiles.
void tst_HeightLayer::aPartRenderedAgainIsThatOfTheWholePage() {
    QFETCH(MapOrientation, orientation);
    std::mt19937 random(5);
    const auto upTo = [&](std::size_t most) { return random() % (most + 1); };
    const auto hill = [&] {
        auto tile = std::make_shared<HeightTile>();
        for (float& height_m : tile->preview_m)
            height_m = upTo(9) == 0 ? std::nanf("") : static_cast<float>(upTo(100)) * 0.1f;
        return tile;
    };
    const HeightStyle style{{0.0f, 10.0f}, orientation, ColorMap::Color, 0.25, 2.0};
    PageTiles page;
    for (std::size_t i = 0; i < PageTiles::count; i += 2)
        page.tiles[i] = hill();
    PagePicture picture = renderPage(page, style);
    for (int change = 0; change < 40; ++change) {
        QRect changed_px;
        for (std::size_t i = 0; i <= upTo(2); ++i) {
            const std::size_t place = upTo(PageTiles::count - 1);
            const auto before = page.tiles[place];
            const auto after = before && upTo(3) > 0 ? std::make_shared<HeightTile>(*before) : hill();
            after->preview_m[upTo(HeightTile::cell_count - 1)] = 5.0f;
            page.tiles[place] = after;
            changed_px |= changedPixels(place, before.get(), *after, orientation);
        }
        picture = renderAgain(page, style, picture, changed_px);
        const PagePicture whole = renderPage(page, style);
        QVERIFY(picture.levels == whole.levels);
        QVERIFY(picture.contours == whole.contours);
    }
}

void tst_HeightLayer::coarseLevelsAverage() {
    auto tile = std::make_shared<HeightTile>();
    tile->preview_m.fill(0.0f);
    tile->height_m.fill(0.0f);
    for (std::size_t i = 0; i < HeightTile::cell_count; i += 2)
        tile->preview_m[i] = 1.0f;
    PageTiles page;
    page.tiles[0] = tile;
    const PagePicture picture = renderPage(page, {{0.0f, 1.0f}, MapOrientation::YUp, ColorMap::Gray});
    QCOMPARE(picture.levels[3].width(), 32);
    const QRgb low = shade(0.0f, {0.0f, 1.0f}, ColorMap::Gray);
    const QRgb high = shade(1.0f, {0.0f, 1.0f}, ColorMap::Gray);
    const int mean = (qRed(low) + qRed(high)) / 2;
    QVERIFY(qAbs(qRed(picture.levels[1].pixel(0, 127)) - mean) <= 1);
    QVERIFY(qAbs(qRed(picture.levels[3].pixel(0, 31)) - mean) <= 1);
    QCOMPARE(qAlpha(picture.levels[3].pixel(31, 0)), 0);
}

void tst_HeightLayer::levelFollowsTheScale() {
    const PagePicture picture = renderPage({}, {});
    QCOMPARE(picture.levelFor(8.0).width(), 256);
    QCOMPARE(picture.levelFor(0.6).width(), 256);
    QCOMPARE(picture.levelFor(0.5).width(), 128);
    QCOMPARE(picture.levelFor(0.001).width(), 32);
}

void tst_HeightLayer::picturesAppearTogether() {
    HeightLayer layer;
    layer.clear(0.25);
    QSignalSpy changed(&layer, &HeightLayer::changed);
    layer.take({tileWith({0, 0}, 0, 0, 1.0f), tileWith({40, 0}, 0, 0, 2.0f)}, HeightRange{1.0f, 2.0f});
    QVERIFY(layer.pages().empty());
    settle(layer);
    QCOMPARE(layer.pages().size(), std::size_t(2));
    QCOMPARE(changed.count(), 1);
}

void tst_HeightLayer::newRangeRecolorsEverything() {
    HeightLayer layer;
    layer.setOrientation(MapOrientation::YUp);
    layer.take({tileWith({0, 0}, 0, 0, 1.0f)}, HeightRange{0.0f, 1.0f});
    settle(layer);
    const QRgb before = layer.pages().begin()->second.levels[0].pixel(0, 255);
    layer.take({}, HeightRange{0.0f, 10.0f});
    settle(layer);
    const QRgb after = layer.pages().begin()->second.levels[0].pixel(0, 255);
    QCOMPARE(before, shade(1.0f, {0.0f, 1.0f}, ColorMap::Color));
    QCOMPARE(after, shade(1.0f, {0.0f, 10.0f}, ColorMap::Color));
    QVERIFY(before != after);
}

/// The scan's mean heights change with each hit; the legend follows at once, the pages as soon as it can be seen.
void tst_HeightLayer::unseenChangesOfTheRangeRecolorNothing() {
    HeightLayer layer;
    layer.take({tileWith({0, 0}, 0, 0, 1.0f)}, HeightRange{0.0f, 20.0f});
    settle(layer);
    layer.take({}, HeightRange{0.0f, 19.99f});
    QVERIFY(!layer.busy());
    QCOMPARE(layer.range(), (HeightRange{0.0f, 19.99f}));
    layer.take({}, HeightRange{0.0f, 18.4f}); // A range may also shrink.
    QVERIFY(layer.busy());
    QCOMPARE(layer.style().range, (HeightRange{0.0f, 18.4f}));
    settle(layer);
}

void tst_HeightLayer::grayAndAFixedRangeAreOneCallAway() {
    HeightLayer layer;
    layer.setOrientation(MapOrientation::YUp);
    layer.take({tileWith({0, 0}, 0, 0, 1.0f)}, HeightRange{0.0f, 2.0f});
    settle(layer);
    const auto color = [&layer] { return layer.pages().begin()->second.levels[0].pixel(0, 255); };
    QCOMPARE(color(), shade(1.0f, {0.0f, 2.0f}, ColorMap::Color));
    layer.setLook({ColorMap::Gray, std::nullopt});
    settle(layer);
    QCOMPARE(color(), shade(1.0f, {0.0f, 2.0f}, ColorMap::Gray));
    layer.setLook({ColorMap::Gray, HeightRange{-10.0f, 10.0f}});
    layer.take({}, HeightRange{0.0f, 5.0f});
    settle(layer);
    QCOMPARE(layer.range(), (HeightRange{-10.0f, 10.0f}));
    QCOMPARE(color(), shade(1.0f, {-10.0f, 10.0f}, ColorMap::Gray));
    layer.setLook({ColorMap::Gray, std::nullopt});
    settle(layer);
    QCOMPARE(layer.range(), (HeightRange{0.0f, 5.0f}));
}

void tst_HeightLayer::oneTreeDoesNotTakeTheColors() {
    HeightLayer layer;
    layer.setOrientation(MapOrientation::YUp);
    layer.setLook({ColorMap::Gray, std::nullopt, true});
    layer.take({slopeWith({0, 0}, 30.0f)}, HeightRange{0.0f, 30.0f});
    settle(layer);
    const HeightRange range = layer.range();
    QVERIFY2(range.minimum_m >= 0.1f - 0.03f && range.minimum_m <= 0.13f, qPrintable(QString::number(range.minimum_m)));
    QVERIFY2(range.maximum_m >= 6.1f && range.maximum_m <= 6.3f, qPrintable(QString::number(range.maximum_m)));
    QCOMPARE(layer.style().range, range);
    QCOMPARE(layer.pages().begin()->second.levels[0].pixel(32, 200), shade(3.2f, range, ColorMap::Gray));
    layer.setLook({ColorMap::Gray, std::nullopt, false});
    QCOMPARE(layer.range(), (HeightRange{0.0f, 30.0f}));
    layer.setLook({ColorMap::Gray, std::nullopt, true});
    QCOMPARE(layer.range(), range);
    settle(layer);
    layer.clear(0.25);
    QCOMPARE(layer.range(), HeightRange{});
}

void tst_HeightLayer::theRangeWithoutTreesIsFoundAtMostOnceASecond() {
    HeightLayer layer;
    layer.setLook({ColorMap::Gray, std::nullopt, true});
    layer.take({slopeWith({0, 0}, 30.0f)}, HeightRange{0.0f, 30.0f});
    settle(layer);
    const HeightRange first = layer.range();
    auto hill = std::make_shared<HeightTile>();
    hill->index = {1, 0};
    hill->preview_m.fill(20.0f);
    QSignalSpy changed(&layer, &HeightLayer::changed);
    layer.take({hill}, HeightRange{0.0f, 30.0f});
    QCOMPARE(layer.range(), first);
    QTRY_VERIFY(layer.range().maximum_m >= 20.0f); // Nothing more has come; half of the ground is not an outlier.
    QVERIFY(changed.count() > 0);
    QCOMPARE(layer.style().range, layer.range());
    settle(layer);
}

void tst_HeightLayer::contoursAreDrawnOnRequest() {
    auto tile = std::make_shared<HeightTile>();
    for (std::size_t i = 0; i < HeightTile::cell_count; ++i)
        tile->preview_m[i] = float(i % HeightTile::side) * 0.5f; // Rises by half a meter from column to column.
    HeightLayer layer;
    layer.setOrientation(MapOrientation::YUp);
    layer.take({tile}, HeightRange{0.0f, 31.5f});
    settle(layer);
    QVERIFY(layer.pages().begin()->second.contours[0].isNull());
    layer.setContours(true);
    settle(layer);
    QCOMPARE(layer.style().contour_step_m, 5.0);
    const QImage lines = layer.pages().begin()->second.contours[0];
    for (int column = 0; column < HeightTile::side; ++column)
        QCOMPARE(qAlpha(lines.pixel(column, 200)) != 0, column > 0 && column % 10 == 0);
    QVERIFY(qAlpha(layer.pages().begin()->second.contoursFor(0.2).pixel(2, 50)) > 0);
}

void tst_HeightLayer::lightComesFromTheUpperLeftOfTheScreen_data() {
    QTest::addColumn<MapOrientation>("orientation");
    QTest::newRow("x up") << MapOrientation::XUp;
    QTest::newRow("y up") << MapOrientation::YUp;
}

/// A roof with its ridge from the lower left to the upper right of the screen: its upper left side is the lighter one.
void tst_HeightLayer::lightComesFromTheUpperLeftOfTheScreen() {
    QFETCH(MapOrientation, orientation);
    MapTransform t;
    t.orientation = orientation;
    const Vec2 to_upper_left = t.toMap(QPointF(-1, -1)) - t.toMap(QPointF(0, 0));
    auto tile = std::make_shared<HeightTile>();
    for (int row = 0; row < HeightTile::side; ++row)
        for (int column = 0; column < HeightTile::side; ++column)
            tile->preview_m[static_cast<std::size_t>(row * HeightTile::side + column)] =
                static_cast<float>(-0.1 * std::abs(Vec2(column - 31.5, row - 31.5).dot(to_upper_left.normalized())));
    PageTiles page;
    page.tiles[0] = tile;
    const QImage image = renderPage(page, {{-5.0f, 0.0f}, orientation}).levels[0];
    t.pixels_per_m = 1.0;
    const QPointF corner = t.toScreen(pageRectangle({0, 0}, 1.0)).topLeft();
    const QPoint middle = (t.toScreen(Vec2(31.5, 31.5)) - corner).toPoint();
    const int light = qGray(image.pixel(middle - QPoint(8, 8)));
    const int dark = qGray(image.pixel(middle + QPoint(8, 8)));
    QVERIFY2(light > dark + 10, qPrintable(QStringLiteral("%1 and %2").arg(light).arg(dark)));
}

void tst_HeightLayer::waitsForARange() {
    HeightLayer layer;
    layer.take({tileWith({0, 0}, 0, 0, 1.0f)}, std::nullopt);
    QVERIFY(layer.pages().empty());
    layer.take({}, HeightRange{0.0f, 1.0f});
    settle(layer);
    QCOMPARE(layer.pages().size(), std::size_t(1));
}

void tst_HeightLayer::clearForgetsWhatIsStillRendered() {
    HeightLayer layer;
    layer.take({tileWith({0, 0}, 0, 0, 1.0f)}, HeightRange{0.0f, 1.0f});
    layer.clear(0.5);
    layer.take({tileWith({8, 0}, 0, 0, 1.0f)}, HeightRange{0.0f, 1.0f});
    settle(layer);
    QCOMPARE(layer.pages().size(), std::size_t(1));
    QCOMPARE(layer.pages().begin()->first, (GridIndex{2, 0}));
    QCOMPARE(layer.cellSize_m(), 0.5);
}

void tst_HeightLayer::probeKnowsHeightAndHits() {
    HeightLayer layer;
    layer.clear(0.25);
    layer.take({tileWith({-1, 0}, 63, 2, 4.25f)}, HeightRange{0.0f, 5.0f});
    const auto probe = layer.probe(Vec2(-0.1, 0.6));
    QVERIFY(probe.has_value());
    QCOMPARE(probe->height_m, 4.25f);
    QCOMPARE(probe->hits, 7);
    QVERIFY(!layer.probe(Vec2(0.1, 0.6)));
    QVERIFY(!layer.probe(Vec2(-0.4, 0.6)));
    QVERIFY(!layer.probe(Vec2(qInf(), 0.0)));
    QVERIFY(!layer.probe(Vec2(qQNaN(), 0.0)));
}

void tst_HeightLayer::boundsCoverAllTiles() {
    HeightLayer layer;
    QVERIFY(layer.bounds_in_map().empty());
    layer.clear(0.25);
    layer.take({tileWith({-1, 0}, 0, 0, 1.0f), tileWith({1, 2}, 0, 0, 1.0f)}, std::nullopt);
    QCOMPARE(layer.bounds_in_map(), (Rectangle{Vec2(-16, 0), Vec2(32, 48)}));
}

USAR_TEST(tst_HeightLayer)

} // namespace tst_height_layer

#include "tst_height_layer.moc"
