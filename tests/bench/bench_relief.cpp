// What a frame of the 3D view costs: a map of 1000 x 1000 known cells, the trail of a robot that has gone over all of
// it in lanes, 1280 x 720 pixels, with levels of detail and with all triangles, side by side; and what it costs that
// the map or the trail grows.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <vector>

#include "core/mapping/relief/relief_scene.h"

namespace {

using namespace usar;
using namespace usar::mapping;

constexpr int side_cells = 1000;
constexpr int width_px = 1280;
constexpr int height_px = 720;

/// Hills with ridges and rubble, known everywhere.
float heightAt(int column, int row) {
    const double x = column / 40.0, y = row / 40.0;
    const double rubble = std::sin(column * 12.9898 + row * 78.233) * 43758.5453;
    return static_cast<float>(6.0 * std::sin(x / 2.0) * std::cos(y / 3.0) + 1.5 * std::abs(std::sin(x + y)) +
                              0.3 * (rubble - std::floor(rubble)));
}

const HeightTiles& hills() {
    static const HeightTiles tiles = [] {
        HeightMap map(0.25);
        for (int row = 0; row < side_cells; ++row)
            for (int column = 0; column < side_cells; ++column)
                map.write({column, row}, heightAt(column, row), {1});
        HeightTiles made;
        for (const auto& tile : map.takeChangedTiles())
            made[tile->index] = tile;
        return made;
    }();
    return tiles;
}

constexpr ReliefStyle style{{-6.0f, 8.0f}};

/// In lanes 5 m apart, with a point each 0.25 m.
std::vector<Vec3> lawnmowerTrail() {
    constexpr double side_m = side_cells * 0.25;
    std::vector<Vec3> points;
    for (int lane = 0; lane < 50; ++lane)
        for (int step = 0; step < side_cells; ++step) {
            const double along_m = 0.25 * step + 0.125;
            points.emplace_back(lane % 2 == 0 ? along_m : side_m - along_m, 5.0 * lane + 2.5, 0.0);
        }
    return points;
}

ReliefScene sceneOf(double square_px, double distance_m, double elevation_deg) {
    static const ReliefSurface surface = [] {
        ReliefSurface made;
        std::vector<GridIndex> all;
        for (const auto& [index, tile] : hills())
            all.push_back(index);
        made.style = style;
        renewRelief(made, hills(), 0.25, all);
        return made;
    }();
    static const std::vector<Vec3> trail = aboveSurface(surface, lawnmowerTrail());
    ReliefScene scene;
    scene.surface = surface;
    scene.lines.push_back({trail, 0xffff8000u, 0xff101418u, 2});
    scene.bodies.push_back({.in_map = {trail.back(), 0.0, 0.0, 0.0}, .color = 0xffff8000u});
    scene.square_px = square_px;
    scene.camera.target_in_map_m = {125.0, 125.0, 0.0};
    scene.camera.yaw_rad = radians(120.0);
    scene.camera.elevation_rad = radians(elevation_deg);
    scene.camera.distance_m = distance_m;
    return scene;
}

/// Arguments: 0 draws all triangles; distance in meters; elevation in degrees; number of threads. The camera turns by a
/// degree from frame to frame.
void drawHills(benchmark::State& state) {
    ReliefScene scene = sceneOf(state.range(0) ? 2.0 : 0.0, double(state.range(1)), double(state.range(2)));
    ReliefPicture picture(width_px, height_px);
    for (auto unused : state) {
        scene.camera.yaw_rad += radians(1.0);
        drawReliefByStrips(scene, picture, int(state.range(3)));
        benchmark::DoNotOptimize(picture.argb.data());
    }
    state.counters["frames_per_s"] = benchmark::Counter(double(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(drawHills)
    ->ArgNames({"levels", "m", "deg", "threads"})
    ->ArgsProduct({{1, 0}, {300}, {35}, {1, 2}}) // all of the map
    ->Args({1, 120, 10, 2})                      // along the ground
    ->Args({1, 400, 90, 2})                      // from above
    ->Args({1, 15, 25, 2})                       // near
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

/// A map of 10,000 tiles, whose colors get another range in each frame. The argument is the number of threads.
void drawManyTiles(benchmark::State& state) {
    static const ReliefSurface surface = [] {
        HeightTiles tiles;
        std::vector<GridIndex> all;
        for (std::int32_t row = 0; row < 100; ++row)
            for (std::int32_t column = 0; column < 100; ++column) {
                tiles[{column, row}] = hills().at({column % 15, row % 15});
                all.push_back({column, row});
            }
        ReliefSurface made;
        made.style = style;
        renewRelief(made, tiles, 0.25, all);
        return made;
    }();
    ReliefScene scene;
    scene.surface = surface;
    scene.camera.target_in_map_m = {800.0, 800.0, 0.0};
    scene.camera.distance_m = 1900.0;
    ReliefPicture picture(width_px, height_px);
    for (auto unused : state) {
        scene.surface.style.range.maximum_m += 0.01f;
        drawReliefByStrips(scene, picture, int(state.range(0)));
        benchmark::DoNotOptimize(picture.argb.data());
    }
}
BENCHMARK(drawManyTiles)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

/// What a camera that shows all of these tiles needs, each time the map grows.
void framePoints(benchmark::State& state) {
    const ReliefScene scene = sceneOf(2.0, 300.0, 35.0);
    for (auto unused : state)
        benchmark::DoNotOptimize(pointsToShow(scene, {}).data());
}
BENCHMARK(framePoints)->Unit(benchmark::kMillisecond);

/// How long all triangles take, as a multiple of the time with levels of detail; frame by frame in turns, so that what
/// else the machine does counts for both.
void allTrianglesByLevels(benchmark::State& state) {
    using Clock = std::chrono::steady_clock;
    ReliefScene levels = sceneOf(2.0, 300.0, 35.0), all = sceneOf(0.0, 300.0, 35.0);
    ReliefPicture picture(width_px, height_px);
    std::chrono::duration<double> with_levels{}, without{};
    for (auto unused : state) {
        const auto began = Clock::now();
        drawReliefByStrips(levels, picture, 2);
        const auto between = Clock::now();
        drawReliefByStrips(all, picture, 2);
        without += Clock::now() - between;
        with_levels += between - began;
    }
    state.counters["ratio"] = without / with_levels;
}
BENCHMARK(allTrianglesByLevels)->UseRealTime()->Unit(benchmark::kMillisecond);

/// The trail is raised above the surface again: what it costs that the robot goes on, or that the map grows.
void raiseTrail(benchmark::State& state) {
    const ReliefSurface surface = sceneOf(2.0, 300.0, 35.0).surface;
    const std::vector<Vec3> trail = lawnmowerTrail();
    for (auto unused : state)
        benchmark::DoNotOptimize(aboveSurface(surface, trail).data());
}
BENCHMARK(raiseTrail)->Unit(benchmark::kMillisecond);

/// A tile and the eight around it are made again: what one scan costs.
void renewTile(benchmark::State& state) {
    ReliefSurface surface = sceneOf(2.0, 300.0, 35.0).surface;
    const GridIndex changed{7, 7};
    for (auto unused : state)
        renewRelief(surface, hills(), 0.25, {&changed, 1});
}
BENCHMARK(renewTile)->Unit(benchmark::kMillisecond);

/// The whole map is made again: what another size of cells costs.
void renewAll(benchmark::State& state) {
    for (auto unused : state) {
        ReliefSurface surface{0.5, style, {}};
        renewRelief(surface, hills(), 0.25, {});
        benchmark::DoNotOptimize(surface.tiles.size());
    }
}
BENCHMARK(renewAll)->Unit(benchmark::kMillisecond);

} // namespace
