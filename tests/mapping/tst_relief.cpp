#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "core/mapping/relief/relief_scene.h"
#include "tests/suite/suite.h"

namespace tst_relief {

using namespace usar;
using namespace usar::mapping;

namespace {

constexpr int width_px = 320;
constexpr int height_px = 240;
constexpr std::uint32_t sky = 0xff0000ffu; // No color of heights is pure blue or pure red.
constexpr std::uint32_t red = 0xffff0000u;

using HeightOf = std::function<float(int column, int row)>;

/// Tiles of a square of cells from (first, first); NaN: unknown.
HeightTiles tilesOf(int first, int end, const HeightOf& heightOf) {
    HeightMap map(0.25);
    for (int row = first; row < end; ++row)
        for (int column = first; column < end; ++column)
            map.write({column, row}, heightOf(column, row), {1});
    HeightTiles tiles;
    for (const auto& tile : map.takeChangedTiles())
        tiles[tile->index] = tile;
    return tiles;
}

ReliefSurface surfaceOf(const HeightTiles& tiles) {
    std::vector<GridIndex> all;
    for (const auto& [index, tile] : tiles)
        all.push_back(index);
    ReliefSurface surface;
    surface.style.range = {-5.0f, 5.0f};
    renewRelief(surface, tiles, 0.25, all);
    return surface;
}

ReliefScene sceneOf(const ReliefSurface& surface, const OrbitCamera& camera) {
    ReliefScene scene;
    scene.surface = surface;
    scene.camera = camera;
    scene.sky = scene.ground = sky;
    return scene;
}

OrbitCamera cameraAt(const Vec3& target_m, double yaw_deg, double elevation_deg, double distance_m) {
    return {target_m, radians(yaw_deg), radians(elevation_deg), distance_m, radians(40.0)};
}

float level(int, int) {
    return 2.0f;
}
float rough(int column, int row) {
    const double noise = std::sin(column * 12.9898 + row * 78.233) * 43758.5453;
    return static_cast<float>(2.0 * std::sin(column / 30.0) * std::cos(row / 23.0) + 0.8 * (noise - std::floor(noise)));
}

Rectangle shownBounds(const ReliefSurface& surface) {
    return boundsOf(tilesToShow(surface), surface.cell_size_m);
}

std::size_t pixelsOf(const ReliefPicture& picture, std::uint32_t color) {
    return static_cast<std::size_t>(std::ranges::count(picture.argb, color));
}

bool same(const ReliefTile& a, const ReliefTile& b) {
    const auto equal = [](float one, float other) { return one == other || (std::isnan(one) && std::isnan(other)); };
    for (std::size_t i = 0; i < a.levels.size(); ++i)
        if (a.levels[i].light != b.levels[i].light ||
            !std::ranges::equal(a.levels[i].blocks_m, b.levels[i].blocks_m, equal) ||
            !std::ranges::equal(a.levels[i].corners_m, b.levels[i].corners_m, equal))
            return false;
    return a.range == b.range && a.known == b.known && a.known_cells == b.known_cells;
}

bool same(const ReliefSurface& a, const ReliefSurface& b) {
    return std::ranges::equal(a.tiles, b.tiles, [](const auto& one, const auto& other) {
        return one.first == other.first && same(*one.second, *other.second);
    });
}

} // namespace

class tst_Relief : public QObject {
    Q_OBJECT
private slots:
    void aSurfaceHasTheHeightsAndHolesOfTheMap_data();
    void aSurfaceHasTheHeightsAndHolesOfTheMap();
    void aNarrowStripIsSeenInEveryLevel();
    void whatIsMadeAgainIsWhatIsMadeAtOnce();
    void anotherStyleColorsTheSameTiles_data();
    void anotherStyleColorsTheSameTiles();
    void squaresHaveTheColorsOfTheMap_data();
    void squaresHaveTheColorsOfTheMap();
    void aRasterHasTheSurfaceOfItsTiles();
    void aHugeRasterIsPutTogether();
    void noGapBetweenLevels_data();
    void noGapBetweenLevels();
    void theNearestIsSeen_data();
    void theNearestIsSeen();
    void aHoleShowsTheBackground();
    void aPickedPixelIsThePointThatIsSeenThere();
    void bandsMakeTheSamePicture();
    void oneFarTileDoesNotWidenTheView();
    void aSmallGroupFarAwayIsLeftOut_data();
    void aSmallGroupFarAwayIsLeftOut();
    void someCornersAreFewOfALargeMap();
    void aRequestToStopEndsIt();
    void aBodyUnderTheGroundIsDrawnOnIt();
    void aLongWayMissesNoRidge();
    void levelsOfDetailLookLikeAllTriangles();
    void anExaggeratedHillIsHigherInThePicture();
    void aRobotPointsWhereItGoes();
    void anOutlineLiesOnTheSurface();
    void aWayIsNotHiddenByTheGround();
};

void tst_Relief::aSurfaceHasTheHeightsAndHolesOfTheMap_data() {
    QTest::addColumn<Vec2>("at_m");
    QTest::addColumn<bool>("known");
    QTest::addColumn<double>("height_m");
    QTest::newRow("in the middle of the plain") << Vec2(1.0, 1.0) << true << 2.0;
    QTest::newRow("on a step: the mean") << Vec2(5.0, 1.0) << true << 2.5;
    QTest::newRow("beyond the step") << Vec2(5.5, 1.0) << true << 3.0;
    QTest::newRow("on the border of tiles") << Vec2(16.0, 16.0) << true << 3.0;
    QTest::newRow("in the hole") << Vec2(2.6, 2.6) << false << 0.0;
    QTest::newRow("beside the hole") << Vec2(2.3, 2.6) << true << 2.0;
    QTest::newRow("outside") << Vec2(-0.1, 1.0) << false << 0.0;
    QTest::newRow("far outside") << Vec2(1e12, 1.0) << false << 0.0;
    QTest::newRow("no place") << Vec2(std::nan(""), 1.0) << false << 0.0;
    QTest::newRow("no row") << Vec2(1.0, std::nan("")) << false << 0.0;
}

void tst_Relief::aSurfaceHasTheHeightsAndHolesOfTheMap() {
    QFETCH(Vec2, at_m);
    QFETCH(bool, known);
    QFETCH(double, height_m);
    const ReliefSurface surface = surfaceOf(tilesOf(0, 80, [](int column, int row) {
        return column == 10 && row == 10 ? std::nanf("") : column < 20 ? 2.0f : 3.0f;
    }));
    const auto found = surface.height_m(at_m);
    QCOMPARE(found.has_value(), known);
    if (found)
        QCOMPARE(double(*found), height_m);
    QCOMPARE(surface.range(), std::optional(HeightRange{2.0f, 3.0f}));
    QCOMPARE(shownBounds(surface), (Rectangle{{0, 0}, {20, 20}}));
}

void tst_Relief::aNarrowStripIsSeenInEveryLevel() {
    const ReliefSurface surface =
        surfaceOf(tilesOf(0, 64, [](int column, int) { return column == 21 ? 1.0f : std::nanf(""); }));
    for (int level_at = 0; level_at < ReliefTile::level_count; ++level_at) {
        bool seen = false;
        for (int i = 0; i < ReliefTile::squaresAt(level_at) && !seen; ++i)
            seen = squareColor(*surface.tiles.at({0, 0}), level_at, i, i / 2, surface.style) != 0;
        QVERIFY(seen);
    }
}

void tst_Relief::whatIsMadeAgainIsWhatIsMadeAtOnce() {
    std::mt19937 random(7);
    HeightMap map(0.25);
    HeightTiles tiles;
    ReliefSurface grown;
    for (int scan = 0; scan < 12; ++scan) {
        const int column = int(random() % 200) - 100, row = int(random() % 200) - 100;
        for (int i = 0; i < 40; ++i)
            for (int j = 0; j < 25; ++j)
                if (random() % 5 > 0)
                    map.write({column + i, row + j}, rough(column + i, row + j), {1});
        std::vector<GridIndex> changed;
        for (const auto& tile : map.takeChangedTiles()) {
            tiles[tile->index] = tile;
            changed.push_back(tile->index);
        }
        renewRelief(grown, tiles, 0.25, changed);
    }
    ReliefSurface at_once;
    std::vector<GridIndex> all;
    for (const auto& [index, tile] : tiles)
        all.push_back(index);
    renewRelief(at_once, tiles, 0.25, all);
    QVERIFY(same(grown, at_once));
}

void tst_Relief::anotherStyleColorsTheSameTiles_data() {
    QTest::addColumn<ReliefStyle>("style");
    QTest::newRow("range") << ReliefStyle{{-50.0f, 5.0f}};
    QTest::newRow("gray") << ReliefStyle{{-5.0f, 5.0f}, ColorMap::Gray};
    QTest::newRow("contours") << ReliefStyle{{-5.0f, 5.0f}, ColorMap::Color, 0.5};
}

void tst_Relief::anotherStyleColorsTheSameTiles() {
    QFETCH(ReliefStyle, style);
    const HeightTiles tiles = tilesOf(-64, 64, rough);
    ReliefSurface surface = surfaceOf(tiles);
    const ReliefSurface before = surface;
    surface.style = style;
    renewRelief(surface, tiles, 0.25, {});
    QVERIFY(std::ranges::equal(surface.tiles, before.tiles)); // The pointers are the same.
    const OrbitCamera camera = cameraAt({0, 0, 0}, 90.0, 60.0, 40.0);
    const ReliefPicture one = drawnRelief(sceneOf(before, camera), width_px, height_px);
    const ReliefPicture other = drawnRelief(sceneOf(surface, camera), width_px, height_px);
    QVERIFY(one.argb != other.argb);
    QVERIFY(one.nearness_per_m == other.nearness_per_m);
}

void tst_Relief::squaresHaveTheColorsOfTheMap_data() {
    QTest::addColumn<ColorMap>("color_map");
    QTest::newRow("color") << ColorMap::Color;
    QTest::newRow("gray") << ColorMap::Gray;
}

/// They differ by less than one of 127 parts of the light can change.
void tst_Relief::squaresHaveTheColorsOfTheMap() {
    QFETCH(ColorMap, color_map);
    ReliefSurface surface = surfaceOf(tilesOf(0, 64, rough));
    surface.style.color_map = color_map;
    std::vector<float> from_the_top;
    for (int row = 63; row >= 0; --row)
        for (int column = 0; column < 64; ++column)
            from_the_top.push_back(rough(column, row));
    const HeightGrid grid{from_the_top, 64, 64, 0.25};
    for (int row = 0; row < 64; ++row)
        for (int column = 0; column < 64; ++column) {
            const std::uint32_t map = shadeCell(grid, column, 63 - row, surface.style.range, color_map);
            const std::uint32_t seen = squareColor(*surface.tiles.at({0, 0}), 0, column, row, surface.style);
            for (const int shift : {0, 8, 16, 24})
                QVERIFY(std::abs(int(map >> shift & 0xff) - int(seen >> shift & 0xff)) <= 1);
        }
}

void tst_Relief::aRasterHasTheSurfaceOfItsTiles() {
    const auto with_holes = [](int column, int row) {
        return (column * 7 + row * 3) % 11 == 0 ? std::nanf("") : rough(column, row);
    };
    HeightMap map(0.25);
    for (int row = -70; row < 90; ++row)
        for (int column = -5; column < 100; ++column)
            map.write({column, row}, with_holes(column, row), {1});
    const ReliefSurface from_raster = reliefOf(rasterOf(map), {{-5.0f, 5.0f}});
    HeightTiles tiles;
    for (const auto& tile : map.takeChangedTiles())
        tiles[tile->index] = tile;
    QVERIFY(same(from_raster, surfaceOf(tiles)));
}

void tst_Relief::aHugeRasterIsPutTogether() {
    HeightMap map(0.25);
    for (int row = -37; row < 163; ++row)
        for (int column = 11; column < 211; ++column)
            map.write({column, row}, float(column), {1});
    const ReliefSurface coarse = reliefOf(rasterOf(map), {{0.0f, 100.0f}}, 12000);
    QCOMPARE(coarse.cell_size_m, 0.5);
    // The corners lie between two columns each.
    QCOMPARE(coarse.height_m({25.0, 15.0}), std::optional(99.5f));
    QVERIFY(coarse.height_m({2.8, -9.2}) && coarse.height_m({52.7, 40.7}));
    QVERIFY(!coarse.height_m({2.4, 0.0}) && !coarse.height_m({53.1, 0.0}));
    const ReliefSurface coarser = reliefOf(rasterOf(map), {{0.0f, 100.0f}}, 3000);
    QCOMPARE(coarser.cell_size_m, 1.0);
    QCOMPARE(coarser.height_m({25.0, 15.0}), std::optional(99.5f));
    QCOMPARE(reliefOf(Raster{}, {}).tiles.size(), std::size_t(0));
}

void tst_Relief::noGapBetweenLevels_data() {
    QTest::addColumn<double>("square_px");
    QTest::newRow("usual") << 2.0;
    QTest::newRow("coarse") << 6.0;
    QTest::newRow("very coarse") << 20.0;
}

/// A way that enters the map from above at the highest height and leaves it below at the lowest one, without leaving it
/// at a side, meets the surface: a map that is known everywhere has no hole.
void tst_Relief::noGapBetweenLevels() {
    QFETCH(double, square_px);
    static const ReliefSurface surface = surfaceOf(tilesOf(-128, 192, rough)); // whole tiles
    const Rectangle inside{{-31.9, -31.9}, {47.9, 47.9}};
    std::mt19937 random(3);
    const auto between = [&random](double low, double high) {
        return std::uniform_real_distribution(low, high)(random);
    };
    constexpr int cameras = 15;
    constexpr int sample_px = 10;
    int meeting = 0;
    const double highest_m = double(surface.range()->maximum_m), lowest_m = double(surface.range()->minimum_m);
    for (int i = 0; i < cameras; ++i) {
        ReliefScene scene = sceneOf(surface, cameraAt({between(-25, 25), between(-25, 25), 0}, between(-180, 180),
                                                      between(10, 90), between(5, 120)));
        scene.square_px = square_px;
        const ReliefPicture picture = drawnRelief(scene, width_px, height_px);
        const ReliefProjection projection(scene.camera, width_px, height_px);
        const auto meetsIt = [&](int x, int y) {
            const auto enters = projection.onPlane(x + 0.5, y + 0.5, highest_m);
            const auto leaves = projection.onPlane(x + 0.5, y + 0.5, lowest_m);
            return enters && leaves && inside.contains(Vec2(enters->head<2>())) &&
                   inside.contains(Vec2(leaves->head<2>()));
        };
        for (int y = 0; y < height_px; ++y)
            for (int x = 0; x < width_px; ++x) {
                if (picture.argb[picture.indexOf(x, y)] == sky && meetsIt(x, y))
                    QFAIL(qPrintable(QString("camera %1: a gap at %2, %3").arg(i).arg(x).arg(y)));
                // Every pixel is looked at above; a sample tells how many of them count.
                if (x % sample_px == 0 && y % sample_px == 0)
                    meeting += meetsIt(x, y);
            }
    }
    QVERIFY(meeting > cameras * (width_px / sample_px) * (height_px / sample_px) / 4);
}

void tst_Relief::theNearestIsSeen_data() {
    QTest::addColumn<std::vector<Vec3>>("line");
    QTest::addColumn<bool>("seen");
    // A wall, 3 m high, stands at y = 10, and the camera looks north.
    QTest::newRow("before the wall") << std::vector<Vec3>{{2, 8, 0.5}, {8, 8, 0.5}} << true;
    QTest::newRow("behind it") << std::vector<Vec3>{{2, 12, 0.5}, {8, 12, 0.5}} << false;
    QTest::newRow("behind and above it") << std::vector<Vec3>{{2, 12, 6.0}, {8, 12, 6.0}} << true;
    QTest::newRow("under the ground") << std::vector<Vec3>{{2, 8, -1.0}, {8, 8, -1.0}} << false;
    QTest::newRow("on the ground") << std::vector<Vec3>{{2, 8, 0.0}, {8, 8, 0.0}} << true;
    QTest::newRow("with a gap") << std::vector<Vec3>{{2, 8, 0.5}, {NAN, NAN, NAN}, {8, 8, 0.5}} << false;
    QTest::newRow("through the camera") << std::vector<Vec3>{{5, 8, 0.5}, {5, -500, 60.0}} << true;
    QTest::newRow("from far behind the camera") << std::vector<Vec3>{{5, 8, 0.5}, {5, -5e5, 6e4}} << true;
    QTest::newRow("NaN in one end") << std::vector<Vec3>{{2, 8, 0.5}, {8, 8, NAN}} << false;
    QTest::newRow("an infinite end") << std::vector<Vec3>{{2, 8, 0.5}, {INFINITY, 8, 0.5}} << false;
    QTest::newRow("infinitely high") << std::vector<Vec3>{{2, 8, 0.5}, {2, 8, INFINITY}} << false;
    QTest::newRow("infinitely far behind") << std::vector<Vec3>{{2, 8, 0.5}, {2, -INFINITY, 0.5}} << false;
    QTest::newRow("beyond single precision") << std::vector<Vec3>{{2, 8, 0.5}, {1e300, 8, 0.5}} << false;
    QTest::newRow("behind, beyond single precision") << std::vector<Vec3>{{2, 8, 0.5}, {2, -1e300, 0.5}} << false;
}

void tst_Relief::theNearestIsSeen() {
    QFETCH(std::vector<Vec3>, line);
    QFETCH(bool, seen);
    static const ReliefSurface surface =
        surfaceOf(tilesOf(0, 64, [](int, int row) { return row == 40 || row == 41 ? 3.0f : 0.0f; }));
    ReliefScene scene = sceneOf(surface, cameraAt({5, 9, 0}, 90.0, 15.0, 25.0));
    scene.lines.push_back({line, red});
    QCOMPARE(pixelsOf(drawnRelief(scene, width_px, height_px), red) > 0, seen);
    std::ranges::reverse(scene.lines[0].points_in_map_m);
    QCOMPARE(pixelsOf(drawnRelief(scene, width_px, height_px), red) > 0, seen);
}

void tst_Relief::aHoleShowsTheBackground() {
    const auto with_hole = [](int column, int row) {
        return column >= 30 && column < 34 && row >= 30 && row < 34 ? std::nanf("") : 2.0f;
    };
    const ReliefSurface surface = surfaceOf(tilesOf(0, 64, with_hole));
    const OrbitCamera camera = cameraAt({8, 8, 2}, 90.0, 90.0, 10.0);
    const ReliefPicture picture = drawnRelief(sceneOf(surface, camera), width_px, height_px);
    // Four cells of 0.25 m at a distance of 10 m.
    const double side_px = ReliefProjection(camera, width_px, height_px).focal_px() / 10.0;
    QVERIFY(std::abs(double(pixelsOf(picture, sky)) - side_px * side_px) < 2.5 * side_px);
    QVERIFY(!picture.pick(width_px / 2, height_px / 2, ReliefProjection(camera, width_px, height_px)));
}

void tst_Relief::aPickedPixelIsThePointThatIsSeenThere() {
    const ReliefSurface surface = surfaceOf(tilesOf(-64, 128, rough));
    std::mt19937 random(11);
    int picked = 0;
    for (const double exaggeration : {1.0, 3.0}) {
        ReliefScene scene = sceneOf(surface, cameraAt({5, 5, 0}, 40.0, 40.0, 30.0));
        scene.square_px = 0.0;
        scene.exaggeration = exaggeration;
        const ReliefPicture picture = drawnRelief(scene, width_px, height_px);
        const ReliefProjection projection(scene.camera, width_px, height_px, exaggeration);
        for (int i = 0; i < 300; ++i) {
            const int x = int(random() % width_px), y = int(random() % height_px);
            const auto point_m = picture.pick(x, y, projection);
            if (!point_m)
                continue;
            ++picked;
            const auto seen = projection.project(*point_m);
            QVERIFY(seen && std::abs(seen->x_px - x - 0.5) < 0.01 && std::abs(seen->y_px - y - 0.5) < 0.01);
            const auto height_m = surface.height_m(point_m->head<2>());
            QVERIFY(height_m && std::abs(double(*height_m) - point_m->z()) < 0.8); // Rubble is as high as that.
        }
        QVERIFY(!picture.pick(-1, 5, projection) && !picture.pick(5, height_px, projection));
    }
    QVERIFY(picked > 300);
}

void tst_Relief::bandsMakeTheSamePicture() {
    ReliefScene scene = sceneOf(surfaceOf(tilesOf(-64, 128, rough)), cameraAt({5, 5, 0}, 40.0, 30.0, 25.0));
    scene.lines.push_back({{{-5, -5, 3}, {20, 20, 3}, {22, -5, 3}}, red, 0xff000000u, 3});
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place_m(-60.0, 60.0);
    for (int width = 1; width <= 4; ++width) {
        ReliefLine line{{}, red + static_cast<std::uint32_t>(width), width % 2 ? 0xff00ff00u : 0u, width};
        for (int i = 0; i < 50; ++i) // Some pass through the camera.
            line.points_in_map_m.emplace_back(place_m(random), place_m(random), place_m(random) / 3.0);
        line.points_in_map_m.emplace_back(line.points_in_map_m.back() + Vec3(0.0, 0.0, 9.0)); // This one is upright.
        scene.lines.push_back(line);
    }
    scene.bodies.push_back({.in_map = {{5, 5, 4}, 0.0, 0.0, 1.0}, .color = red});
    const ReliefPicture whole = drawnRelief(scene, width_px, height_px);
    for (std::size_t i = 0; i < scene.lines.size(); ++i)
        QVERIFY(pixelsOf(whole, scene.lines[i].color) > 0);
    ReliefPicture by_bands(width_px, height_px);
    for (const PictureBand band : {PictureBand{200, 320}, PictureBand{0, 33}, PictureBand{33, 200}})
        drawRelief(scene, by_bands, band);
    QVERIFY(whole.argb == by_bands.argb);
    QVERIFY(whole.nearness_per_m == by_bands.nearness_per_m);
    for (const int threads : {1, 3}) {
        ReliefPicture by_strips(width_px, height_px);
        drawReliefByStrips(scene, by_strips, threads);
        QVERIFY(whole.argb == by_strips.argb);
        QVERIFY(whole.nearness_per_m == by_strips.nearness_per_m);
    }
}

void tst_Relief::oneFarTileDoesNotWidenTheView() {
    HeightTiles tiles = tilesOf(0, 192, level);
    const ReliefSurface near = surfaceOf(tiles);
    constexpr int far = 1 << 29; // A garbled position makes a tile there.
    tiles.merge(tilesOf(far, far + 1, level));
    tiles.merge(tilesOf(-far, 1 - far, level));
    const ReliefSurface surface = surfaceOf(tiles);
    QCOMPARE(surface.tiles.size(), near.tiles.size() + 2);
    QCOMPARE(shownBounds(surface), (Rectangle{{0, 0}, {48, 48}}));
    QVERIFY(pointsToShow(sceneOf(surface, {}), {}) == pointsToShow(sceneOf(near, {}), {}));
    // Where no tile is near the median, the nearest one counts.
    HeightMap map(0.25);
    for (const GridIndex cell : {GridIndex{0, far}, GridIndex{far, -far}, GridIndex{-far, 0}})
        map.write(cell, 2.0f, {1});
    HeightTiles scattered;
    for (const auto& tile : map.takeChangedTiles())
        scattered[tile->index] = tile;
    QCOMPARE(shownBounds(surfaceOf(scattered)).width_m(), 0.25);
}

void tst_Relief::aSmallGroupFarAwayIsLeftOut_data() {
    QTest::addColumn<int>("first"); // of a square of cells beside one of 128 from (0, 0)
    QTest::addColumn<int>("side");
    QTest::addColumn<Rectangle>("area_in_map");
    QTest::addColumn<bool>("shown");
    QTest::newRow("a scan far away") << 6400 << 10 << Rectangle{} << false;
    QTest::newRow("on the other side") << -6400 << 10 << Rectangle{} << false;
    QTest::newRow("in the area") << 6400 << 10 << Rectangle{{1595, 1595}, {1605, 1605}} << true;
    QTest::newRow("beside the area") << 6400 << 10 << Rectangle{{0, 0}, {1595, 1595}} << false;
    QTest::newRow("as large as a quarter") << 6400 << 64 << Rectangle{} << true;
    QTest::newRow("smaller than a quarter") << 6400 << 63 << Rectangle{} << false;
    QTest::newRow("as near as the rest is long") << 256 << 10 << Rectangle{} << true;
    QTest::newRow("farther than that") << 320 << 10 << Rectangle{} << false;
}

void tst_Relief::aSmallGroupFarAwayIsLeftOut() {
    QFETCH(int, first);
    QFETCH(int, side);
    QFETCH(Rectangle, area_in_map);
    QFETCH(bool, shown);
    HeightTiles tiles = tilesOf(0, 128, level);
    tiles.merge(tilesOf(first, first + side, level));
    const ReliefSurface surface = surfaceOf(tiles);
    const auto points = pointsToShow(sceneOf(surface, {}), std::span(&area_in_map, 1));
    const double middle_m = 0.25 * (first + side / 2);
    QCOMPARE(std::ranges::any_of(points, [&](const Vec3& point) { return std::abs(point.x() - middle_m) < 17.0; }),
             shown);
    QVERIFY(std::ranges::any_of(points, [](const Vec3& point) { return point == Vec3(32, 32, 2); }));
}

void tst_Relief::someCornersAreFewOfALargeMap() {
    ReliefSurface surface = surfaceOf(tilesOf(0, 64, level));
    const auto tile = surface.tiles.at({0, 0});
    const std::vector<const ReliefTile*> many(10000, tile.get());
    const std::vector<Vec3> corners = someCorners(many, 0.25);
    QVERIFY(corners.size() >= 4 * many.size() && corners.size() < 120000);
    QVERIFY(std::ranges::find(corners, Vec3(16, 16, 2)) != corners.end());
}

void tst_Relief::aRequestToStopEndsIt() {
    HeightMap map(0.25);
    for (int row = 0; row < 100; ++row)
        for (int column = 0; column < 100; ++column)
            map.write({column, row}, 1.0f, {1});
    std::stop_source source;
    const Raster raster = rasterOf(map);
    for (const int most_cells : {100000, 1000})
        QCOMPARE(reliefOf(raster, {}, most_cells, source.get_token()).tiles.empty(), false);
    source.request_stop();
    for (const int most_cells : {100000, 1000})
        QVERIFY(reliefOf(raster, {}, most_cells, source.get_token()).tiles.empty());
    QVERIFY(drawnRelief(sceneOf({}, {}), width_px, height_px, source.get_token()).empty());
}

void tst_Relief::aBodyUnderTheGroundIsDrawnOnIt() {
    ReliefScene scene = sceneOf(surfaceOf(tilesOf(0, 64, level)), cameraAt({8, 8, 2}, 90.0, 40.0, 60.0));
    constexpr std::uint32_t trail_color = 0xff00ff00u;
    scene.lines.push_back({aboveSurface(scene.surface, {{2, 8, -1}, {14, 8, -1}}), trail_color, 0, 3});
    const auto drawnAt = [&scene](double z_m, bool pointed) {
        scene.bodies = {{.in_map = {{8, 8, z_m}, 0.0, 0.0, 1.0}, .color = red, .pointed = pointed}};
        return drawnRelief(scene, width_px, height_px);
    };
    for (const bool pointed : {true, false}) {
        const ReliefPicture below = drawnAt(-1.0, pointed);
        QVERIFY(below.argb == drawnAt(2.0, pointed).argb);
        QVERIFY(below.argb != drawnAt(4.0, pointed).argb);
        // The trail goes through its middle, which is in the middle of the picture.
        QVERIFY(below.argb[below.indexOf(width_px / 2, height_px / 2)] != trail_color);
        QVERIFY(pixelsOf(below, trail_color) > 0);
    }
}

void tst_Relief::aLongWayMissesNoRidge() {
    const auto ridges = [](int column, int) { return column % 40 == 20 ? 5.0f : 1.0f; };
    const ReliefSurface surface = surfaceOf(tilesOf(0, 600, ridges));
    const std::vector<Vec3> way = aboveSurface(surface, {{1, 8, 1.5}, {149, 8, 1.5}});
    const std::vector<Vec3> outline = outlineOnSurface(surface, {{1, 8}, {149, 20}});
    for (int column = 20; column < 600; column += 40) {
        const double ridge_m = 0.25 * (column + 0.5);
        for (const auto& points : {way, outline})
            QVERIFY(std::ranges::any_of(points, [ridge_m](const Vec3& point) {
                return std::abs(point.x() - ridge_m) < 0.3 && point.z() == 3.0;
            }));
    }
    for (const double far_m : {1e9, 1e300})
        QVERIFY(outlineOnSurface(surface, {{-far_m, -far_m}, {far_m, far_m}}).size() < 20000);
}

void tst_Relief::levelsOfDetailLookLikeAllTriangles() {
    const auto smooth = [](int column, int row) {
        return static_cast<float>(2.0 * std::sin(column / 30.0) * std::cos(row / 23.0));
    };
    ReliefScene scene = sceneOf(surfaceOf(tilesOf(-150, 170, smooth)), cameraAt({0, 0, 0}, 60.0, 40.0, 110.0));
    const ReliefPicture fine = [&] {
        scene.square_px = 0.0;
        return drawnRelief(scene, width_px, height_px);
    }();
    scene.square_px = 2.0;
    const ReliefPicture levels = drawnRelief(scene, width_px, height_px);
    QVERIFY(fine.argb != levels.argb);
    double difference = 0.0;
    std::size_t other_silhouette = 0;
    for (std::size_t i = 0; i < fine.argb.size(); ++i) {
        other_silhouette += (fine.argb[i] == sky) != (levels.argb[i] == sky);
        for (const int shift : {0, 8, 16})
            difference += std::abs(double(fine.argb[i] >> shift & 0xff) - double(levels.argb[i] >> shift & 0xff));
    }
    QVERIFY(difference / double(3 * fine.argb.size()) < 2.0);
    QVERIFY(other_silhouette < fine.argb.size() / 200);
}

void tst_Relief::anExaggeratedHillIsHigherInThePicture() {
    const ReliefSurface surface = surfaceOf(
        tilesOf(0, 64, [](int column, int row) { return std::hypot(column - 32, row - 32) < 3.0 ? 4.0f : 0.0f; }));
    const auto topOf = [&](double exaggeration) {
        ReliefScene scene = sceneOf(surface, cameraAt({8, 8, 0}, 90.0, 10.0, 40.0));
        scene.exaggeration = exaggeration;
        const ReliefPicture picture = drawnRelief(scene, width_px, height_px);
        return std::ranges::find_if(picture.argb, [](std::uint32_t color) { return color != sky; }) -
               picture.argb.begin();
    };
    QVERIFY(topOf(2.0) < topOf(1.0) - 10 * width_px);
}

void tst_Relief::aRobotPointsWhereItGoes() {
    ReliefScene scene = sceneOf({}, cameraAt({0, 0, 0}, 90.0, 90.0, 50.0));
    /// How far the picture of the robot reaches to the right, left, top and bottom of its place.
    const auto reachOf = [&](double yaw_rad) {
        scene.bodies = {{.in_map = {Vec3::Zero(), 0.0, 0.0, yaw_rad}, .color = red, .least_px = 40}};
        const ReliefPicture picture = drawnRelief(scene, width_px, height_px);
        std::array<int, 4> reach{};
        for (int y = 0; y < height_px; ++y)
            for (int x = 0; x < width_px; ++x)
                if (picture.argb[picture.indexOf(x, y)] != sky) {
                    const int right = x - width_px / 2, up = height_px / 2 - y;
                    reach = {std::max(reach[0], right), std::max(reach[1], -right), std::max(reach[2], up),
                             std::max(reach[3], -up)};
                }
        return reach;
    };
    // From half a length ahead to four tenths behind, and 0.35 to each side.
    const auto about = [](std::array<int, 4> reach, std::array<int, 4> wanted) {
        return std::ranges::equal(reach, wanted, [](int a, int b) { return std::abs(a - b) <= 2; });
    };
    QVERIFY(about(reachOf(0.0), {20, 16, 14, 14}));
    QVERIFY(about(reachOf(pi / 2), {14, 14, 20, 16}));
    QVERIFY(about(reachOf(pi), {16, 20, 14, 14}));
}

void tst_Relief::anOutlineLiesOnTheSurface() {
    const ReliefSurface surface = surfaceOf(tilesOf(0, 64, level));
    const std::vector<Vec3> points = outlineOnSurface(surface, {{-3, 2}, {5, 6}});
    QCOMPARE(points.front(), Vec3(-3, 2, 2)); // Nothing is known there.
    QVERIFY(std::ranges::all_of(points, [](const Vec3& point) { return point.z() == 2.0; }));
    QVERIFY(std::ranges::find(points, Vec3(5, 6, 2)) != points.end());
    QVERIFY(outlineOnSurface(surface, {}).empty());
}

void tst_Relief::aWayIsNotHiddenByTheGround() {
    const ReliefSurface surface =
        surfaceOf(tilesOf(0, 64, [](int column, int) { return column >= 30 && column < 34 ? 3.0f : 1.0f; }));
    const std::vector<Vec3> way{{2, 8, 1.5}, {14, 8, 1.5}, Vec3::Constant(NAN), {-5, 8, -2}};
    const std::vector<Vec3> raised = aboveSurface(surface, way);
    QCOMPARE(raised.front(), way.front());
    QVERIFY(std::ranges::any_of(raised, [](const Vec3& point) { return point == Vec3(14, 8, 1.5); }));
    QCOMPARE(raised.back(), way.back()); // Nothing is known there.
    QCOMPARE(std::ranges::count_if(raised, [](const Vec3& point) { return !point.allFinite(); }), 1);
    for (const Vec3& point : raised)
        QVERIFY(!surface.height_m(point.head<2>()) || point.z() >= double(*surface.height_m(point.head<2>())));
    QVERIFY(std::ranges::any_of(raised, [](const Vec3& point) { return point.z() == 3.0; }));
}

USAR_TEST(tst_Relief)

} // namespace tst_relief
#include "tst_relief.moc"
