// What a scan costs on its way into the map, and what the map costs in memory: 181 beams from 6 m, one lane after the
// other over hills, at the thesis's 5 Hz.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/mapping/coverage_path.h"
#include "core/mapping/height_map.h"
#include "core/mapping/raster_export.h"
#include "core/mapping/scan_integrator.h"
#include "core/mapping/shading.h"

namespace {

using namespace usar;
using namespace usar::mapping;

constexpr double altitude_m = 6.0;
constexpr double step_m = 0.15; // 0.75 m/s at 5 Hz
constexpr double lane_m = 60.0;

/// Ranges over gently waved ground: what matters is how far apart beams land.
std::vector<double> scanAt(double along_m) {
    std::vector<double> ranges_m;
    for (int k = 0; k <= 180; ++k) {
        const double angle_rad = radians(k - 90);
        const double flat_m = altitude_m / std::max(1e-6, std::cos(angle_rad));
        ranges_m.push_back(std::min(20.0, flat_m * (1.0 + 0.05 * std::sin(along_m / 3 + 5 * angle_rad))));
    }
    return ranges_m;
}

struct Scan {
    std::vector<double> ranges_m;
    Pose scanner_in_map;
};

std::vector<Scan> scansOfLanes(int lanes) {
    std::vector<Scan> scans;
    for (int lane = 0; lane < lanes; ++lane) {
        for (double s = 0.0; s < lane_m; s += step_m) {
            const bool back = lane % 2 != 0;
            const Pose scanner{{back ? lane_m - s : s, 10.0 * lane, altitude_m}, 0.0, pi / 2, back ? pi : 0.0};
            scans.push_back({scanAt(s), scanner});
        }
    }
    return scans;
}

void fly(const std::vector<Scan>& scans, HeightMap& map) {
    ScanIntegrator integrator;
    std::uint64_t line = 0;
    for (const Scan& scan : scans)
        integrator.integrate({scan.ranges_m, pi / 180, pi, 20.0}, scan.scanner_in_map, {++line}, map);
}

/// Argument: cell size in centimetres.
void integrateScans(benchmark::State& state) {
    const std::vector<Scan> scans = scansOfLanes(4);
    std::size_t bytes = 0;
    std::size_t cells = 0;
    for (auto unused : state) {
        HeightMap map(double(state.range(0)) / 100.0);
        fly(scans, map);
        bytes = map.memoryBytes();
        cells = map.knownCellCount();
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(scans.size()));
    state.counters["time_per_scan"] = benchmark::Counter(
        double(scans.size()), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    state.counters["MB"] = double(bytes) / 1e6;
    state.counters["bytes_per_cell"] = double(bytes) / double(cells);
}
BENCHMARK(integrateScans)->Arg(25)->Arg(10)->Unit(benchmark::kMillisecond);

/// A frame of a running scan: what three new scans changed, copied and shaded.
void handOutAFrame(benchmark::State& state) {
    const std::vector<Scan> scans = scansOfLanes(1);
    HeightMap map(double(state.range(0)) / 100.0);
    fly(scans, map);
    map.takeChangedTiles();
    ScanIntegrator integrator;
    std::vector<std::uint32_t> pixels(HeightTile::cell_count);
    std::size_t tiles = 0;
    std::size_t next = 0;
    for (auto unused : state) {
        for (int i = 0; i < 3; ++i, next = (next + 1) % scans.size())
            integrator.integrate({scans[next].ranges_m, pi / 180, pi, 20.0}, scans[next].scanner_in_map, {1}, map);
        const HeightRange range = map.range().value_or(HeightRange{});
        for (const auto& tile : map.takeChangedTiles()) {
            const HeightGrid grid{tile->height_m, HeightTile::side, HeightTile::side, map.cellSize_m()};
            for (std::size_t i = 0; i < pixels.size(); ++i)
                pixels[i] = shadeCell(grid, std::int64_t(i) % HeightTile::side, std::int64_t(i) / HeightTile::side,
                                      range, ColorMap::Color);
            benchmark::DoNotOptimize(pixels.data());
            ++tiles;
        }
    }
    state.counters["tiles"] = benchmark::Counter(double(tiles), benchmark::Counter::kAvgIterations);
}
BENCHMARK(handOutAFrame)->Arg(25)->Arg(10)->Unit(benchmark::kMicrosecond);

void rasterOfAScan(benchmark::State& state) {
    HeightMap map(0.25);
    fly(scansOfLanes(4), map);
    for (auto unused : state)
        benchmark::DoNotOptimize(rasterOf(map));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(map.knownCellCount()));
}
BENCHMARK(rasterOfAScan)->Unit(benchmark::kMillisecond);

/// Argument: side of the square in metres. The window plans anew at every mouse move.
void planASquare(benchmark::State& state) {
    const double half_m = double(state.range(0)) / 2;
    for (auto unused : state)
        benchmark::DoNotOptimize(planCoverage({{-half_m, -half_m}, {half_m, half_m}}, {1.0, 2.0}, {10.0}));
}
BENCHMARK(planASquare)->Arg(60)->Arg(200)->Arg(1000)->Arg(6000)->Unit(benchmark::kMicrosecond);

} // namespace
