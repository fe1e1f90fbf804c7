// One play of an ERS in the simulation, judged: what the loop test and the long campaign share.
#pragma once

#include <QTest>

#include "core/sim/worlds/made_worlds.h"
#include "robots/ers/descriptions.h"
#include "tests/doubles/shipped_robots.h"
#include "tests/doubles/simulated_flight.h"

namespace usar::test {

struct Play {
    sim::RobotTruth truth;
    double worst_tilt_rad = 0.0;
    std::optional<agent::BehaviorFinished> ending;
    std::vector<std::string> events;
};

/// From the four start poses on the field in turn, by the seed.
inline Play play(std::uint64_t seed, Seconds duration) {
    const sim::World world = sim::makeSpqrSoccer(1);
    const sim::NamedPose& start = world.start_poses[(seed - 1) % 4];
    sim::SimulationOptions options;
    options.seed = seed;
    options.battery_life = duration * 2.0;
    options.robots = doubles::shippedRobots();
    auto simulation = sim::Simulation::make(world, options);
    const auto parameters = agent::ParameterSet::make(ers::ErsRobot().description().behaviors[0].parameters,
                                                      {{"play_time_s", duration.count()}});
    auto behavior = ers::ErsRobot().createBehavior("ers/cpp", {{"R1", start.pose_in_map, {}}, parameters.value()});
    SimulatedFlight flight(std::move(simulation.value()), std::move(behavior.value()), start.pose_in_map,
                           "USARBot.ERS");
    Play result;
    flight.run(duration + Seconds(10.0), [&] {
        const Pose base_in_map = flight.truth().base_in_map;
        result.worst_tilt_rad =
            std::max({result.worst_tilt_rad, std::abs(base_in_map.roll_rad), std::abs(base_in_map.pitch_rad)});
    });
    result.truth = flight.truth();
    result.ending = flight.ending();
    result.events = flight.events();
    qInfo("seed %llu from %s: first touch %.1f s, %d touches, %d falls, tilt at most %.0f degrees, %.1f m",
          static_cast<unsigned long long>(seed), start.name.c_str(),
          result.truth.first_touch ? result.truth.first_touch->count() : -1.0, result.truth.touches, result.truth.falls,
          degrees(result.worst_tilt_rad), result.truth.distance_m);
    return result;
}

} // namespace usar::test
