// What simulated time costs: physics in flight and landed, sensors, and whole ticks with their text.
#include <benchmark/benchmark.h>

#include <string>

#include "core/base/numbers.h"
#include "core/base/random.h"
#include "core/sim/drives/rotor_drive.h"
#include "core/sim/robots/robot.h"
#include "core/sim/robots/robot_body.h"
#include "core/sim/simulation.h"
#include "core/sim/world/world_reader.h"
#include "tests/doubles/shipped_robots.h"

namespace {

using namespace usar;
using namespace usar::sim;

constexpr Seconds dt{0.004};

World tallTest() {
    auto world = readWorld(USAR_BINARY_DIR "/share/worlds/tall_test");
    return world ? std::move(*world) : World{};
}

Pose overTheStart(const World& world, double above_m) {
    Pose base_in_map = world.start_poses.front().pose_in_map;
    base_in_map.position_m.z() += above_m;
    return base_in_map;
}

void physicsStep(benchmark::State& state) {
    const World world = tallTest();
    const auto physics = makePhysics(world);
    const RobotModel& model = *findRobot(*doubles::shippedRobots(), "AirRobot");
    const RobotBody body(*physics, model, overTheStart(world, static_cast<double>(state.range(0))));
    RotorDrive robot(*physics, body.id(), state.range(0) < 1);
    const auto step = [&] {
        robot.beforeStep(dt);
        physics->step(dt);
        robot.afterStep(dt);
    };
    for (int i = 0; i < 2000; ++i) // 8 s: flying on the spot, or landed and asleep
        step();
    for (auto _ : state)
        step();
    state.SetLabel(state.range(0) > 0 ? "flying" : "landed");
}
BENCHMARK(physicsStep)->Arg(10)->Arg(0)->Unit(benchmark::kMicrosecond);

/// A robot on the ground that may not sleep: what its contacts and joints cost.
void jointedStep(benchmark::State& state, const char* class_name) {
    const World world = tallTest();
    const auto physics = makePhysics(world);
    const RobotModel& model = *findRobot(*doubles::shippedRobots(), class_name);
    RobotBody body(*physics, model, overTheStart(world, model.dimensions_m.z()));
    for (int i = 0; i < 1000; ++i)
        physics->step(dt);
    for (auto _ : state)
        physics->step(dt);
}
BENCHMARK_CAPTURE(jointedStep, P2DX, "P2DX")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(jointedStep, P2AT, "P2AT")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(jointedStep, Sedan, "Sedan")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(jointedStep, ERS, "ERS")->Unit(benchmark::kMicrosecond);

void sensorTick(benchmark::State& state) {
    const World world = tallTest();
    const auto physics = makePhysics(world);
    const RayCaster caster(world);
    const RobotModel& model = *findRobot(*doubles::shippedRobots(), "AirRobot");
    Scene scene;
    RobotOptions options;
    options.base_in_map = overTheStart(world, 6.0);
    const auto robot = std::move(*Robot::spawn(model, {world, caster, *physics, scene}, options));
    std::vector<protocol::InfoMessage> lines;
    for (auto _ : state) {
        lines.clear();
        robot->measure(Seconds{1.0}, false, lines);
        benchmark::DoNotOptimize(lines.data());
    }
}
BENCHMARK(sensorTick)->Unit(benchmark::kMicrosecond);

/// Simulated seconds per second of processor time, with the text of all lines. Robots wander above the trees.
void realTimeFactor(benchmark::State& state) {
    SimulationOptions options;
    options.battery_life = Seconds{1e6};
    options.robots = doubles::shippedRobots();
    auto simulation = std::move(*Simulation::make(tallTest(), options));
    std::vector<ClientId> clients;
    for (int i = 0; i < state.range(0); ++i) {
        clients.push_back(simulation->connect());
        const int x_m = 10 * (i % 20) - 95;
        const int y_m = 12 * (i / 20 % 10) - 54;
        simulation->receive(clients.back(), "INIT {ClassName AirRobot} {Location " + std::to_string(x_m) + "," +
                                                std::to_string(y_m) +
                                                ",-30}\r\nDRIVE {LinearVelocity 1} {RotationalVelocity 0.5}\r\n");
    }
    std::size_t bytes = 0;
    for (auto _ : state) {
        simulation->step();
        for (const ClientId client : clients)
            bytes += simulation->takeOutput(client).size();
    }
    const double simulated_s = simulation->now().count();
    state.counters["real_time_factor"] = benchmark::Counter(simulated_s, benchmark::Counter::kIsRate);
    state.counters["bytes_per_tick"] = static_cast<double>(bytes) / static_cast<double>(state.iterations());
}
BENCHMARK(realTimeFactor)->Arg(1)->Arg(10)->Arg(50)->Arg(200)->Unit(benchmark::kMicrosecond);

World vmacRoom() {
    auto world = readWorld(USAR_BINARY_DIR "/share/worlds/vmac_room");
    return world ? std::move(*world) : World{};
}

/// An ERS steps with the legs of one diagonal and then with the others; one that stood would fall asleep.
const std::vector<std::string> steps_of_legs = {"MULTIDRIVE {LFLeg1 0.5} {LFLeg3 0.6} {RHLeg1 0.5} {RHLeg3 0.6} "
                                                "{RFLeg1 0.1} {RFLeg3 0.3} {LHLeg1 0.1} {LHLeg3 0.3}",
                                                "MULTIDRIVE {LFLeg1 0.1} {LFLeg3 0.3} {RHLeg1 0.1} {RHLeg3 0.3} "
                                                "{RFLeg1 0.5} {RFLeg3 0.6} {LHLeg1 0.5} {LHLeg3 0.6}"};

/// The same for robots that move about in a hall, each by the commands of its kind, one a tick in turn.
void groundRealTimeFactor(benchmark::State& state, const std::string& class_name,
                          const std::vector<std::string>& commands) {
    SimulationOptions options;
    options.battery_life = Seconds{1e6};
    options.robots = doubles::shippedRobots();
    auto simulation = std::move(*Simulation::make(vmacRoom(), options));
    std::vector<ClientId> clients;
    for (int i = 0; i < state.range(0); ++i) {
        clients.push_back(simulation->connect());
        const double x_m = 2.0 * (i % 10) - 9.0;
        const double y_m = 2.0 * (i / 10) - 4.0;
        simulation->receive(clients.back(), "INIT {ClassName " + class_name + "} {Location " + std::to_string(x_m) +
                                                "," + std::to_string(y_m) + ",-0.5}\r\n");
    }
    std::size_t tick = 0;
    for (auto _ : state) {
        for (const ClientId client : clients)
            simulation->receive(client, commands[tick % commands.size()] + "\r\n");
        ++tick;
        simulation->step();
        for (const ClientId client : clients)
            benchmark::DoNotOptimize(simulation->takeOutput(client).size());
    }
    if (simulation->robots().size() != clients.size())
        return state.SkipWithError("not every robot was spawned");
    state.counters["real_time_factor"] = benchmark::Counter(simulation->now().count(), benchmark::Counter::kIsRate);
}
BENCHMARK_CAPTURE(groundRealTimeFactor, P2DX, "P2DX", {"DRIVE {Left 3} {Right 4}"})
    ->Arg(1)
    ->Arg(50)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(groundRealTimeFactor, P2AT, "P2AT", {"DRIVE {Left 2} {Right 4}"})
    ->Arg(1)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(groundRealTimeFactor, Sedan, "Sedan", {"DRIVE {Speed 2} {FrontSteer 0.4}"})
    ->Arg(1)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(groundRealTimeFactor, ERS, "ERS", steps_of_legs)->Arg(1)->Unit(benchmark::kMicrosecond);

/// A tick of a world whose crates lie still; 0 is the world without them.
void cratesAtRest(benchmark::State& state) {
    World world = tallTest();
    world.boxes.clear();
    world.plants.clear();
    world.objects.clear();
    for (int i = 0; i < state.range(0); ++i) {
        const Vec2 at_m(2.0 * (i % 50) - 49.0, 2.0 * (i / 50) - 39.0);
        const double height_m = world.terrain.height_m(at_m) + 0.3;
        world.objects.push_back({.name = "Crate" + std::to_string(i),
                                 .class_name = {},
                                 .body = {1.0, Vec3::Constant(0.01), 0.9, {{BoxShape{{0.2, 0.2, 0.2}}, Pose{}}}},
                                 .body_in_map = Pose{{at_m.x(), at_m.y(), height_m}}});
    }
    auto simulation = std::move(*Simulation::make(std::move(world), SimulationOptions{}));
    for (int i = 0; i < 300; ++i) // They fall, and lie still after a minute.
        simulation->step();
    const double began_s = simulation->now().count();
    for (auto _ : state)
        simulation->step();
    state.counters["real_time_factor"] =
        benchmark::Counter(simulation->now().count() - began_s, benchmark::Counter::kIsRate);
}
BENCHMARK(cratesAtRest)->Arg(0)->Arg(200)->Arg(2000)->Unit(benchmark::kMicrosecond);

} // namespace
