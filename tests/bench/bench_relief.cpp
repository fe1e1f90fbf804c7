// What a frame of the 3D view costs: a map of 1000 x 1000 known cells, 1280 x 720 pixels, with levels of detail and
// with all triangles, side by side; and what it costs that the map grows.
#include <benchmark/benchmark.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <thread>
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

ReliefScene sceneOf(double square_px, double distance_m, double elevation_deg) {
    static const ReliefSurface surface = [] {
        ReliefSurface made;
        std::vector<GridIndex> all;
        for (const auto& [index, tile] : hills())
            all.push_back(index);
        renewRelief(made, hills(), 0.25, style, all);
        return made;
    }();
    ReliefScene scene;
    scene.surface = surface;
    scene.square_px = square_px;
    scene.camera.target_in_map_m = {125.0, 125.0, 0.0};
    scene.camera.yaw_rad = radians(120.0);
    scene.camera.elevation_rad = radians(elevation_deg);
    scene.camera.distance_m = distance_m;
    return scene;
}

/// As the view does: strips of the picture, drawn by as many threads as there are processors.
void drawFrame(const ReliefScene& scene, ReliefPicture& picture, unsigned threads) {
    constexpr int strips = 8;
    std::atomic<int> next = 0;
    const auto work = [&] {
        for (int strip = next++; strip < strips; strip = next++)
            drawRelief(scene, picture, {strip * width_px / strips, (strip + 1) * width_px / strips});
    };
    std::vector<std::jthread> others;
    for (unsigned i = 1; i < threads; ++i)
        others.emplace_back(work);
    work();
}

/// Arguments: 0 draws all triangles; distance in meters; elevation in degrees; number of threads. The camera turns by a
/// degree from frame to frame.
void drawHills(benchmark::State& state) {
    ReliefScene scene = sceneOf(state.range(0) ? 2.0 : 0.0, double(state.range(1)), double(state.range(2)));
    ReliefPicture picture(width_px, height_px);
    for (auto unused : state) {
        scene.camera.yaw_rad += radians(1.0);
        drawFrame(scene, picture, unsigned(state.range(3)));
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

/// How long all triangles take, as a multiple of the time with levels of detail; frame by frame in turns, so that what
/// else the machine does counts for both.
void allTrianglesByLevels(benchmark::State& state) {
    using Clock = std::chrono::steady_clock;
    ReliefScene levels = sceneOf(2.0, 300.0, 35.0), all = sceneOf(0.0, 300.0, 35.0);
    ReliefPicture picture(width_px, height_px);
    std::chrono::duration<double> with_levels{}, without{};
    for (auto unused : state) {
        const auto began = Clock::now();
        drawFrame(levels, picture, 2);
        const auto between = Clock::now();
        drawFrame(all, picture, 2);
        without += Clock::now() - between;
        with_levels += between - began;
    }
    state.counters["ratio"] = without / with_levels;
}
BENCHMARK(allTrianglesByLevels)->UseRealTime()->Unit(benchmark::kMillisecond);

/// A tile and the eight around it are made again: what one scan costs.
void renewTile(benchmark::State& state) {
    ReliefSurface surface = sceneOf(2.0, 300.0, 35.0).surface;
    const GridIndex changed{7, 7};
    for (auto unused : state)
        renewRelief(surface, hills(), 0.25, style, {&changed, 1});
}
BENCHMARK(renewTile)->Unit(benchmark::kMillisecond);

/// The whole map is made again: what another range of colors costs.
void renewAll(benchmark::State& state) {
    for (auto unused : state) {
        ReliefSurface surface{0.5, style, {}};
        renewRelief(surface, hills(), 0.25, style, {});
        benchmark::DoNotOptimize(surface.tiles.size());
    }
}
BENCHMARK(renewAll)->Unit(benchmark::kMillisecond);

} // namespace
