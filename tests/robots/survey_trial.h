// One survey of tall_test in the simulation, judged: what the loop test and the long campaign share.
#pragma once

#include <cmath>
#include <vector>

#include <QTest>

#include "core/sim/worlds/made_worlds.h"
#include "robots/airrobot/descriptions.h"
#include "tests/doubles/shipped_robots.h"
#include "tests/doubles/simulated_flight.h"

namespace usar::test {

/// Flies the behavior over `area_in_map` from PlayerStart of the world that ships; reports figures, demands a landing,
/// no collision and 95 % of the cells.
inline void trySurvey(std::uint64_t seed, const Rectangle& area_in_map, Seconds limit, Seconds tick = Seconds(0.2)) {
    const sim::World world = sim::makeTallTest(1);
    const Pose start_in_map = world.start_poses.front().pose_in_map;
    sim::SimulationOptions options;
    options.seed = seed;
    options.physics_steps_per_tick =
        static_cast<int>(std::lround(options.physics_steps_per_tick * (tick / options.tick)));
    options.tick = tick;
    options.battery_life = limit; // the simulator cannot charge: the behavior's own battery is the one that counts
    options.robots = doubles::shippedRobots();
    auto simulation = sim::Simulation::make(world, options);
    QVERIFY(simulation);
    const auto parameters = agent::ParameterSet::make(airrobot::AirRobot().description().behaviors[0].parameters);
    auto behavior = airrobot::AirRobot().createBehavior(
        "airrobot/cpp", {{"R1", start_in_map, area_in_map, sim::dryAbove_m(world)}, *parameters});
    QVERIFY(behavior);
    SimulatedFlight flight(std::move(*simulation), std::move(*behavior), start_in_map);
    std::vector<agent::BehaviorStatus> told;
    flight.run(limit, [&] { told.push_back(flight.status()); });
    qInfo("seed %llu: %.2f %% covered, %d collisions, %.0f s, %.0f m, %d charges",
          static_cast<unsigned long long>(seed), flight.coverage_pct(area_in_map), flight.truth().collisions,
          flight.status().elapsed.count(), flight.status().distance_flown_m, flight.status().charges);
    QCOMPARE(flight.truth().collisions, 0);
    QVERIFY(flight.ending());
    QVERIFY2(flight.ending()->success, flight.ending()->reason.c_str());
    QVERIFY(flight.coverage_pct(area_in_map) >= 95.0);
    const Seconds whole = flight.status().elapsed;
    for (const agent::BehaviorStatus& status : told) // From a tenth of the mission on, the end is told within 12 %.
        if (status.elapsed > whole * 0.1) {
            QVERIFY(status.time_left);
            QVERIFY2(std::abs((status.elapsed + *status.time_left - whole) / whole) <= 0.12,
                     qPrintable(QString("after %1 s, %2 s were told to be left; it took %3 s")
                                    .arg(status.elapsed.count())
                                    .arg(status.time_left->count())
                                    .arg(whole.count())));
        }
    QVERIFY((flight.truth().base_in_map.position_m - start_in_map.position_m).norm() < 5.0);
}

} // namespace usar::test
