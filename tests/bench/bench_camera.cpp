// What a camera's picture costs: 320 x 240 over four worlds, one that says in numbers how many are made while the
// simulation of the robot runs on the same core, and the parts of it.
#include <benchmark/benchmark.h>

#include <string>

#include "core/sim/camera/picture.h"
#include "core/sim/camera/renderer.h"
#include "core/sim/simulation.h"
#include "core/sim/worlds/made_worlds.h"
#include "tests/doubles/shipped_robots.h"

namespace {

using namespace usar;

std::unique_ptr<sim::Simulation> withCar(sim::World world) {
    const Vec3 start_m = world.start_poses.front().pose_in_map.position_m;
    auto simulation = std::move(*sim::Simulation::make(std::move(world), {.robots = doubles::shippedRobots()}));
    const sim::ClientId client = simulation->connect();
    simulation->receive(client, "INIT {ClassName USARBot.P2AT} {Name R1} {Location " + std::to_string(start_m.x()) +
                                    "," + std::to_string(-start_m.y()) + "," + std::to_string(-start_m.z()) + "}\r\n");
    for (int tick = 0; tick < 10; ++tick)
        simulation->step();
    return simulation;
}

void makePictures(benchmark::State& state, sim::World world) {
    const auto simulation = withCar(std::move(world));
    const sim::CameraScene scene = simulation->cameraScene();
    for (auto _ : state)
        benchmark::DoNotOptimize(sim::render(scene, scene.cameras.front()));
    state.counters["frames/s"] =
        benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

void pictureOfTallTest(benchmark::State& state) {
    makePictures(state, sim::makeTallTest(1));
}
BENCHMARK(pictureOfTallTest)->Unit(benchmark::kMillisecond);

void pictureOfVmacRoom(benchmark::State& state) {
    makePictures(state, sim::makeVmacRoom(1));
}
BENCHMARK(pictureOfVmacRoom)->Unit(benchmark::kMillisecond);

void pictureOfPointLookout(benchmark::State& state) {
    makePictures(state, sim::makePointLookout(1));
}
BENCHMARK(pictureOfPointLookout)->Unit(benchmark::kMillisecond);

void pictureOfSoccerField(benchmark::State& state) {
    makePictures(state, sim::makeSpqrSoccer(1));
}
BENCHMARK(pictureOfSoccerField)->Unit(benchmark::kMillisecond);

/// Each frame with its snapshot, its JPEG, and a tenth of a second of simulated time: frames/s above 10 is what issue
/// and thesis ask for in real time.
void tenthOfSecondWithPicture(benchmark::State& state) {
    const auto simulation = withCar(sim::makeTallTest(1));
    int frames = 0;
    for (auto _ : state) {
        if (++frames % 2 == 0)
            simulation->step();
        const sim::CameraScene scene = simulation->cameraScene();
        benchmark::DoNotOptimize(sim::jpegOf(sim::render(scene, scene.cameras.front()), 75));
    }
    state.counters["frames/s"] =
        benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(tenthOfSecondWithPicture)->Unit(benchmark::kMillisecond);

void encodeJpeg(benchmark::State& state) {
    const auto simulation = withCar(sim::makeTallTest(1));
    const sim::CameraScene scene = simulation->cameraScene();
    const sim::Picture picture = sim::render(scene, scene.cameras.front());
    for (auto _ : state)
        benchmark::DoNotOptimize(sim::jpegOf(picture, 75));
}
BENCHMARK(encodeJpeg)->Unit(benchmark::kMillisecond);

} // namespace
