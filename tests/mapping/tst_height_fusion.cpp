#include <QTest>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "core/mapping/height_fusion.h"
#include "tests/suite/suite.h"

namespace tst_height_fusion {

using namespace usar;
using namespace usar::mapping;

namespace {

using Tiles = std::vector<std::shared_ptr<const HeightTile>>;

/// What one robot sends in one update.
struct Update {
    ConnectionId robot;
    double cell_size_m = 0.25;
    Tiles tiles;
};

bool same(float a, float b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

bool same(const HeightTile& a, const HeightTile& b) {
    const auto alike = [](float x, float y) { return same(x, y); };
    return a.index == b.index && std::ranges::equal(a.height_m, b.height_m, alike) &&
           std::ranges::equal(a.preview_m, b.preview_m, alike) && a.hits == b.hits && a.line == b.line;
}

bool same(const HeightTiles& a, const HeightTiles& b) {
    return std::ranges::equal(a, b, [](const auto& x, const auto& y) { return same(*x.second, *y.second); });
}

HeightTiles tilesOf(const HeightMap& map) {
    HeightTiles tiles;
    for (const GridIndex& index : map.tileIndices())
        tiles[index] = std::make_shared<const HeightTile>(*map.tile(index));
    return tiles;
}

Tiles listOf(const HeightTiles& tiles) {
    Tiles list;
    for (const auto& [index, tile] : tiles)
        list.push_back(tile);
    return list;
}

/// Measures and fills around the origin, so that four tiles get cells.
void scanSomewhere(HeightMap& map, std::mt19937& random, int values) {
    std::uniform_int_distribution<std::int32_t> cell(-20, 19);
    std::uniform_real_distribution<float> height(-3.0f, 12.0f);
    for (int i = 0; i < values; ++i) {
        const GridIndex at{cell(random), cell(random)};
        const LineNumber line{static_cast<std::uint64_t>(i + 1)};
        if (random() % 3 == 0)
            map.fill(at, height(random), line);
        else
            map.write(at, height(random), line);
    }
}

/// Fuses everything at once.
HeightTiles fusedAtOnce(const std::vector<std::pair<ConnectionId, const HeightMap*>>& maps) {
    HeightFusion fusion;
    for (const auto& [robot, map] : maps)
        fusion.take(robot, map->cellSize_m(), listOf(tilesOf(*map)));
    (void)fusion.takeChange();
    return fusion.tiles();
}

HeightProbe probed(const HeightFusion& fusion, double x_m, double y_m) {
    return probeHeight(fusion.tiles(), fusion.cellSize_m(), {x_m, y_m}).value_or(HeightProbe{-99.0f, -1});
}

/// A map with one measured or filled cell.
HeightMap oneCell(float height_m, bool measured, double cell_size_m = 0.25) {
    HeightMap map(cell_size_m);
    if (measured)
        map.write({2, 2}, height_m, {7});
    else
        map.fill({2, 2}, height_m, {7});
    return map;
}

} // namespace

class tst_HeightFusion : public QObject {
    Q_OBJECT
private slots:
    void theMapOfOneRobotStaysAsItIs();
    void aCellOfTwoRobotsFollowsTheRule_data();
    void aCellOfTwoRobotsFollowsTheRule();
    void theOrderOfArrivalDoesNotMatter();
    void changesGiveTheSameAsEverythingAtOnce();
    void theRangeIsThatOfTheCellsThereAreNow();
    void withoutARobotTheMapIsAsIfItHadNeverBeenThere();
    void aReplayThatStartsOverTakesItsHeightsBack();
    void onlyWhatHasChangedIsTold();
    void aPlaceOfOneRobotSharesItsTile();
    void hitsDoNotOverflow();
    void theSmallestCellsAreTheGrid();
    void largerCellsGiveTheirValueToAllThatTheyCover_data();
    void largerCellsGiveTheirValueToAllThatTheyCover();
};

void tst_HeightFusion::theMapOfOneRobotStaysAsItIs() {
    std::mt19937 random(3);
    HeightMap map(0.25);
    HeightFusion fusion;
    for (int update = 0; update < 20; ++update) {
        scanSomewhere(map, random, 50);
        fusion.take({4}, 0.25, map.takeChangedTiles());
        const HeightChange change = fusion.takeChange();
        QCOMPARE(change.range, map.range());
        QVERIFY(same(fusion.tiles(), tilesOf(map)));
    }
}

void tst_HeightFusion::aCellOfTwoRobotsFollowsTheRule_data() {
    QTest::addColumn<bool>("first_measured");
    QTest::addColumn<bool>("second_measured");
    QTest::addColumn<float>("height_m");
    QTest::addColumn<int>("hits");
    QTest::newRow("both measured: the mean") << true << true << 3.0f << 2;
    QTest::newRow("both filled: the mean") << false << false << 3.0f << 0;
    QTest::newRow("measured beats filled") << true << false << 2.0f << 1;
    QTest::newRow("measured beats filled, whoever came first") << false << true << 4.0f << 1;
}

void tst_HeightFusion::aCellOfTwoRobotsFollowsTheRule() {
    QFETCH(bool, first_measured);
    QFETCH(bool, second_measured);
    QFETCH(float, height_m);
    QFETCH(int, hits);
    const HeightMap first = oneCell(2.0f, first_measured);
    const HeightMap second = oneCell(4.0f, second_measured);
    const HeightTiles fused = fusedAtOnce({{{1}, &first}, {{2}, &second}});
    const auto probe = probeHeight(fused, 0.25, {0.6, 0.6});
    QVERIFY(probe);
    QCOMPARE(probe->height_m, height_m);
    QCOMPARE(probe->hits, hits);
    const std::size_t cell = 2 * HeightTile::side + 2;
    const HeightTile& tile = *fused.at({0, 0});
    QCOMPARE(tile.preview_m[cell], height_m);
    QCOMPARE(tile.line[cell], first_measured != second_measured ? std::uint64_t(7) : std::uint64_t(0));
}

void tst_HeightFusion::theOrderOfArrivalDoesNotMatter() {
    std::mt19937 random(11);
    std::vector<Update> updates;
    for (int robot = 1; robot <= 5; ++robot) {
        HeightMap map(robot == 4 ? 0.5 : 0.25);
        scanSomewhere(map, random, 300);
        for (const auto& [index, tile] : tilesOf(map))
            updates.push_back({{robot}, map.cellSize_m(), {tile}});
    }
    std::optional<HeightTiles> first;
    for (int order = 0; order < 10; ++order) {
        std::ranges::shuffle(updates, random);
        HeightFusion fusion;
        for (const Update& update : updates) {
            fusion.take(update.robot, update.cell_size_m, update.tiles);
            if (random() % 2 == 0)
                (void)fusion.takeChange();
        }
        (void)fusion.takeChange();
        if (!first)
            first = fusion.tiles();
        QVERIFY(same(fusion.tiles(), *first));
    }
}

void tst_HeightFusion::changesGiveTheSameAsEverythingAtOnce() {
    std::mt19937 random(5);
    HeightMap a(0.25), b(0.25), c(0.25);
    HeightFusion fusion;
    HeightTiles told;
    for (int update = 0; update < 30; ++update) {
        HeightMap& map = update % 3 == 0 ? a : update % 3 == 1 ? b : c;
        scanSomewhere(map, random, 40);
        fusion.take({update % 3 + 1}, 0.25, map.takeChangedTiles());
        for (const auto& tile : fusion.takeChange().tiles)
            told[tile->index] = tile;
    }
    QVERIFY(same(told, fusedAtOnce({{{1}, &a}, {{2}, &b}, {{3}, &c}})));
}

/// The legend of the map shows it, and may not keep heights that no cell has any more.
void tst_HeightFusion::theRangeIsThatOfTheCellsThereAreNow() {
    HeightMap map(0.25);
    HeightFusion fusion;
    const auto rangeAfter = [&](float height_m) {
        map.write({2, 2}, height_m, {1});
        fusion.take({1}, 0.25, map.takeChangedTiles());
        return fusion.takeChange().range;
    };
    QVERIFY(rangeAfter(10.0f) == (HeightRange{10.0f, 10.0f}));
    QVERIFY(rangeAfter(-4.0f) == (HeightRange{3.0f, 3.0f})); // The mean of both.
    fusion.take({2}, 0.25, listOf(tilesOf(oneCell(5.0f, true))));
    QVERIFY(fusion.takeChange().range == (HeightRange{4.0f, 4.0f}));
    fusion.remove({2});
    QVERIFY(fusion.takeChange().range == (HeightRange{3.0f, 3.0f}));
}

void tst_HeightFusion::withoutARobotTheMapIsAsIfItHadNeverBeenThere() {
    std::mt19937 random(8);
    HeightMap a(0.25), b(0.25);
    scanSomewhere(a, random, 300);
    scanSomewhere(b, random, 300);
    b.write({500, 500}, 99.0f, {1}); // A tile that nobody else has.
    HeightFusion fusion;
    fusion.take({1}, 0.25, listOf(tilesOf(a)));
    fusion.take({2}, 0.25, listOf(tilesOf(b)));
    QVERIFY(fusion.takeChange().range->maximum_m == 99.0f);
    fusion.remove({2});
    fusion.remove({3}); // It has never been there.
    const HeightChange change = fusion.takeChange();
    QVERIFY(change.from_scratch);
    QCOMPARE(change.tiles.size(), fusion.tiles().size());
    QCOMPARE(change.range, a.range());
    QVERIFY(same(fusion.tiles(), tilesOf(a)));
    fusion.remove({1});
    const HeightChange last = fusion.takeChange();
    QVERIFY(last.from_scratch && last.tiles.empty() && !last.range && fusion.tiles().empty());
    QVERIFY(!fusion.changed());
}

void tst_HeightFusion::aReplayThatStartsOverTakesItsHeightsBack() {
    HeightMap early(0.25);
    early.write({0, 0}, 1.0f, {1});
    HeightMap late(0.25);
    late.write({0, 0}, 1.0f, {1});
    late.write({300, 0}, 5.0f, {2});
    HeightFusion fusion;
    fusion.take({1}, 0.25, listOf(tilesOf(late)));
    (void)fusion.takeChange();
    fusion.take({1}, 0.25, listOf(tilesOf(early)), true);
    const HeightChange change = fusion.takeChange();
    QVERIFY(change.from_scratch);
    QVERIFY(same(fusion.tiles(), tilesOf(early)));
    fusion.take({1}, 0.25, {}, true);
    QVERIFY(fusion.takeChange().tiles.empty() && fusion.tiles().empty());
}

void tst_HeightFusion::onlyWhatHasChangedIsTold() {
    HeightMap map(0.25);
    map.write({0, 0}, 1.0f, {1});
    map.write({100, 0}, 2.0f, {1});
    HeightFusion fusion;
    fusion.take({1}, 0.25, map.takeChangedTiles());
    QCOMPARE(fusion.takeChange().tiles.size(), std::size_t(2));
    QVERIFY(!fusion.changed());
    map.write({100, 0}, 2.0f, {2});
    fusion.take({1}, 0.25, map.takeChangedTiles());
    QVERIFY(fusion.changed());
    const HeightChange change = fusion.takeChange();
    QVERIFY(!change.from_scratch);
    QCOMPARE(change.tiles.size(), std::size_t(1));
    QCOMPARE(change.tiles.front()->index, (GridIndex{1, 0}));
}

void tst_HeightFusion::aPlaceOfOneRobotSharesItsTile() {
    const HeightMap map = oneCell(2.0f, true);
    const Tiles tiles = listOf(tilesOf(map));
    HeightFusion fusion;
    fusion.take({1}, 0.25, tiles);
    QCOMPARE(fusion.takeChange().tiles.front().get(), tiles.front().get());
}

void tst_HeightFusion::hitsDoNotOverflow() {
    HeightMap map(0.25);
    for (int i = 0; i < 40000; ++i)
        map.write({2, 2}, 1.0f, {1});
    HeightFusion fusion;
    fusion.take({1}, 0.25, listOf(tilesOf(map)));
    fusion.take({2}, 0.25, listOf(tilesOf(map)));
    (void)fusion.takeChange();
    QCOMPARE(probed(fusion, 0.6, 0.6).hits, 65535);
}

void tst_HeightFusion::theSmallestCellsAreTheGrid() {
    const HeightMap coarse = oneCell(2.0f, true, 0.5);
    const HeightMap fine = oneCell(4.0f, true, 0.25);
    HeightFusion fusion;
    fusion.take({1}, 0.5, listOf(tilesOf(coarse)));
    QCOMPARE(fusion.takeChange().cell_size_m, 0.5);
    fusion.take({2}, 0.25, listOf(tilesOf(fine)));
    const HeightChange finer = fusion.takeChange();
    QVERIFY(finer.from_scratch);
    QCOMPARE(finer.cell_size_m, 0.25);
    QCOMPARE(probed(fusion, 0.6, 0.6).height_m, 4.0f); // x, y in 0.5..0.75: the fine cell alone
    QCOMPARE(probed(fusion, 1.3, 1.3).height_m, 2.0f); // 1..1.5: the coarse one
    fusion.remove({2});
    QCOMPARE(fusion.takeChange().cell_size_m, 0.5);
    QVERIFY(same(fusion.tiles(), tilesOf(coarse)));
}

void tst_HeightFusion::largerCellsGiveTheirValueToAllThatTheyCover_data() {
    QTest::addColumn<double>("coarse_m");
    QTest::newRow("twice as large") << 0.5;
    QTest::newRow("four times") << 1.0;
    QTest::newRow("no multiple") << 0.6;
    QTest::newRow("hardly larger") << 0.26;
}

/// Every center of a fused cell gets exactly what the coarse map says there.
void tst_HeightFusion::largerCellsGiveTheirValueToAllThatTheyCover() {
    QFETCH(double, coarse_m);
    std::mt19937 random(2);
    HeightMap coarse(coarse_m);
    scanSomewhere(coarse, random, 900);
    HeightMap fine(0.25);
    fine.write({4000, 4000}, 0.0f, {1}); // Far away: it only sets the grid.
    HeightFusion fusion;
    fusion.take({1}, coarse_m, listOf(tilesOf(coarse)));
    fusion.take({2}, 0.25, listOf(tilesOf(fine)));
    (void)fusion.takeChange();
    int known = 0;
    for (double x_m = -0.25 * 80 + 0.125; x_m < 20.0; x_m += 0.25)
        for (double y_m = -0.25 * 80 + 0.125; y_m < 20.0; y_m += 0.25) {
            const auto expected = coarse.height_m(coarse.cellAt({x_m, y_m}));
            const auto got = probeHeight(fusion.tiles(), 0.25, {x_m, y_m});
            QCOMPARE(got.has_value(), expected.has_value());
            if (got)
                QCOMPARE(got->height_m, *expected);
            known += got.has_value();
        }
    QVERIFY(known > 500);
}

USAR_TEST(tst_HeightFusion)

} // namespace tst_height_fusion

#include "tst_height_fusion.moc"
