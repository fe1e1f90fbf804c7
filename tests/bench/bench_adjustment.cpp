// What it costs to correct a mission's map: of a square of 200 m a side with things like crowns, at 2 m/s and with as
// many scans as the preset "balanced" takes there. Compare with what the scans cost on their way into the map.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "core/mapping/map_rebuild.h"
#include "core/mapping/scan_integrator.h"
#include "core/mapping/strip_adjustment.h"
#include "tests/mapping/made_up_flight.h"

namespace {

using namespace usar;
using namespace usar::mapping;

constexpr double cell_m = 0.25;

/// Hills with a steep bump of 2.5 m every 6 m.
double bumps(double x_m, double y_m) {
    const double column_m = std::remainder(x_m, 6.0), row_m = std::remainder(y_m, 6.0);
    return made_up::hills(x_m / 3.0, y_m / 3.0) + 2.5 * std::exp(-(column_m * column_m + row_m * row_m) / 0.6);
}

/// Lanes at half that distance, because a robot that surveys 200 m by 200 m also flies extra lanes and ways home.
const ScanStore& scans() {
    static const made_up::FlownStrips flown = made_up::fly({.ground_m = bumps,
                                                            .lanes = 24,
                                                            .lane_m = 200.0,
                                                            .spacing_m = 8.75,
                                                            .height_m = 8.0,
                                                            .step_m = 0.4,
                                                            .beams_aside = 60,
                                                            .lands = true,
                                                            .sidles = true});
    return flown.store;
}

StripResult adjusted() {
    StripAdjustment adjustment(scans());
    while (adjustment.step()) {
    }
    return adjustment.result();
}

/// How many scans there are, and what each takes.
void count(benchmark::State& state) {
    state.counters["scans"] = double(scans().scans().size());
    state.counters["time_per_scan"] = benchmark::Counter(
        double(scans().scans().size()), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void writeTheScans(benchmark::State& state) {
    scans();
    for (auto unused : state) {
        HeightMap map(cell_m);
        ScanIntegrator integrator;
        std::vector<double> ranges_m;
        for (const KeptScan& scan : scans().scans()) {
            if (!scan.continues)
                integrator.breakStrip();
            integrator.integrate(scan.beams(ranges_m), scan.scanner_in_map, scan.line, map);
        }
        benchmark::DoNotOptimize(map.knownCellCount());
    }
    count(state);
}
BENCHMARK(writeTheScans)->Unit(benchmark::kMillisecond);

void adjustTheStrips(benchmark::State& state) {
    scans();
    for (auto unused : state)
        if (adjusted().verdict != AdjustmentVerdict::Adjusted)
            state.SkipWithError("nothing was adjusted");
    count(state);
}
BENCHMARK(adjustTheStrips)->Unit(benchmark::kMillisecond);

void makeTheMapAgain(benchmark::State& state) {
    const StripResult result = adjusted();
    for (auto unused : state) {
        MapRebuild rebuild(scans(), result.correction, HeightMap(cell_m));
        while (rebuild.step()) {
        }
        benchmark::DoNotOptimize(rebuild.takeMap().knownCellCount());
    }
    count(state);
}
BENCHMARK(makeTheMapAgain)->Unit(benchmark::kMillisecond);

} // namespace
