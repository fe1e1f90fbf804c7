// One dive of a Submarine in the simulation, judged: what the loop test and the long campaign share.
#pragma once

#include <algorithm>
#include <cmath>

#include <QTest>

#include "core/sim/worlds/building.h"
#include "core/sim/worlds/made_worlds.h"
#include "robots/submarine/descriptions.h"
#include "tests/doubles/shipped_robots.h"
#include "tests/doubles/simulated_flight.h"

namespace usar::test {

/// What the truth says of a dive. Heights are over the bottom straight below, from when the robot first had its height.
struct Dive {
    sim::RobotTruth truth;
    double rms_error_m = 0.0;
    double least_m = 1e9;
    double steepest_rad = 0.0;   ///< of the nose, downward
    double share_near_pct = 0.0; ///< of the time within a meter and a half of the height
    std::optional<agent::BehaviorFinished> ending;
};

/// Sums up where the robot is, tick by tick.
class DiveJudge {
public:
    static constexpr double height_m = 4.0;

    void look(const sim::World& world, const Pose& base_in_map) {
        const Vec3 at_m = base_in_map.position_m;
        const double error_m = at_m.z() - world.terrain.height_m(at_m.head<2>()) - height_m;
        arrived_ = arrived_ || error_m < 0.5;
        if (!arrived_)
            return;
        ++ticks_;
        squares_m2_ += error_m * error_m;
        near_ += std::abs(error_m) < 1.5 ? 1 : 0;
        dive_.least_m = std::min(dive_.least_m, error_m + height_m);
        dive_.steepest_rad = std::max(dive_.steepest_rad, base_in_map.pitch_rad);
    }
    Dive dive(const SimulatedFlight& flight) {
        dive_.rms_error_m = std::sqrt(squares_m2_ / std::max(1, ticks_));
        dive_.share_near_pct = 100.0 * near_ / std::max(1, ticks_);
        dive_.truth = flight.truth();
        dive_.ending = flight.ending();
        return dive_;
    }

private:
    Dive dive_;
    bool arrived_ = false;
    int ticks_ = 0;
    int near_ = 0;
    double squares_m2_ = 0.0;
};

inline Dive dive(const sim::World& world, const Pose& start_in_map, std::uint64_t seed, Seconds duration,
                 std::map<std::string, agent::ParameterValue> values = {}) {
    sim::SimulationOptions options;
    options.seed = seed;
    options.battery_life = duration * 2.0;
    options.robots = doubles::shippedRobots();
    auto simulation = sim::Simulation::make(world, options);
    values.emplace("dive_time_s", duration.count());
    const auto parameters =
        agent::ParameterSet::make(submarine::SubmarineRobot().description().behaviors[0].parameters, values);
    auto behavior =
        submarine::SubmarineRobot().createBehavior("submarine/cpp", {{"R1", start_in_map, {}}, parameters.value()});
    SimulatedFlight flight(std::move(simulation.value()), std::move(behavior.value()), start_in_map,
                           "USARBot.Submarine");
    DiveJudge judge;
    flight.run(duration + Seconds(10.0), [&] { judge.look(world, flight.truth().base_in_map); });
    const Dive result = judge.dive(flight);
    qInfo("seed %llu: %.0f m, rms error %.2f m, %.0f %% within 1.5 m, least height %.2f m, %d touches, at %.0f %.0f",
          static_cast<unsigned long long>(seed), result.truth.distance_m, result.rms_error_m, result.share_near_pct,
          result.least_m, result.truth.collisions, result.truth.base_in_map.position_m.x(),
          result.truth.base_in_map.position_m.y());
    return result;
}

/// From the three start poses over deep water in turn, by the seed.
inline Dive diveInTheSea(std::uint64_t seed, Seconds duration) {
    const sim::World world = sim::makePointLookout(1);
    const char* const names[] = {"OpenSea", "NorthSea", "Bay"};
    const auto start = std::ranges::find(world.start_poses, names[(seed - 1) % 3], &sim::NamedPose::name);
    return dive(world, start->pose_in_map, seed, duration);
}

} // namespace usar::test
