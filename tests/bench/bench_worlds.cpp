// What worlds cost: to make from a seed, to load, to make ready for rays and physics; and what they hold in memory.
#include <benchmark/benchmark.h>

#include <malloc.h>

#include <string>

#include "core/sim/physics/physics.h"
#include "core/sim/rays/ray_caster.h"
#include "core/sim/world/world_generator.h"
#include "core/sim/world/world_reader.h"

namespace {

using namespace usar::sim;

double allocatedMegabytes() {
    const struct mallinfo2 info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd) / 1e6;
}

void makeWorldFromSeed(benchmark::State& state, const std::string& name) {
    for (auto _ : state)
        benchmark::DoNotOptimize(makeWorld(name, 1, USAR_SOURCE_DIR "/resources/worlds"));
}

/// From its files to the first ray and the first step.
void loadWorld(benchmark::State& state, const std::string& name) {
    const std::string folder = USAR_BINARY_DIR "/share/worlds/" + name;
    double megabytes = 0.0;
    for (auto _ : state) {
        const double before = allocatedMegabytes();
        const auto world = readWorld(folder);
        if (!world)
            return state.SkipWithError(world.error().text().c_str());
        const RayCaster caster(*world);
        const auto physics = makePhysics(*world);
        megabytes = allocatedMegabytes() - before;
    }
    state.counters["megabytes"] = megabytes;
}

const bool registered = [] {
    for (const std::string& name : generatedWorldNames()) {
        benchmark::RegisterBenchmark(("makeWorld/" + name).c_str(), makeWorldFromSeed, name)
            ->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(("loadWorld/" + name).c_str(), loadWorld, name)->Unit(benchmark::kMillisecond);
    }
    return true;
}();

} // namespace
