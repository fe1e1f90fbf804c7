// One drive of a P2DX in the simulation, judged: what the loop test and the long campaign share.
#pragma once

#include <QTest>

#include "core/sim/worlds/made_worlds.h"
#include "robots/p2dx/descriptions.h"
#include "tests/doubles/shipped_robots.h"
#include "tests/doubles/simulated_flight.h"

namespace usar::test {

/// Worlds as they ship, and the areas of the missions that ship.
enum class DriveWorld { Room, Meadow };

inline Rectangle areaOf(DriveWorld where) {
    return where == DriveWorld::Room ? Rectangle{{-20.0, -12.5}, {20.0, 12.5}}
                                     : Rectangle{{-36.0, -26.0}, {36.0, 26.0}};
}

/// From the start poses of the room in turn, by the seed; on the meadow there is but one. Reports figures; demands no
/// place in which it stayed for more than a minute, and no collision; on the meadow at most one, because the hills
/// there are so steep (24 degrees) that a robot which turns may slide down backward.
inline void tryDrive(DriveWorld where, const std::string& behavior_id, std::uint64_t seed, Seconds duration) {
    const sim::World world = where == DriveWorld::Room ? sim::makeVmacRoom(1) : sim::makeTallTest(1);
    const std::size_t starts = where == DriveWorld::Room ? world.start_poses.size() : 1;
    const Pose start_in_map = world.start_poses[(seed - 1) % starts].pose_in_map;
    sim::SimulationOptions options;
    options.seed = seed;
    options.battery_life = duration * 2.0;
    options.robots = doubles::shippedRobots();
    auto simulation = sim::Simulation::make(world, options);
    QVERIFY(simulation);
    const auto parameters = agent::ParameterSet::make(p2dx::P2dxRobot().description().behaviors[0].parameters,
                                                      {{"drive_time_s", duration.count()}});
    QVERIFY(parameters);
    auto behavior = p2dx::P2dxRobot().createBehavior(behavior_id, {{"R1", start_in_map, areaOf(where)}, *parameters});
    QVERIFY(behavior);
    SimulatedFlight drive(std::move(*simulation), std::move(*behavior), start_in_map, "USARBot.P2DX");
    drive.run(duration + Seconds(10.0));
    const sim::RobotTruth truth = drive.truth();
    qInfo("%s, seed %llu, %.0f s: %.1f m, %d collisions, longest stay %.1f s, at %.1f %.1f", behavior_id.c_str(),
          static_cast<unsigned long long>(seed), drive.status().elapsed.count(), truth.distance_m, truth.collisions,
          truth.longest_stay.count(), truth.base_in_map.position_m.x(), truth.base_in_map.position_m.y());
    QVERIFY(truth.collisions <= (where == DriveWorld::Room ? 0 : 1));
    QVERIFY(truth.longest_stay < Seconds(60.0));
    QVERIFY(drive.ending());
    QVERIFY2(drive.ending()->success, drive.ending()->reason.c_str());
    QVERIFY(areaOf(where).contains(truth.base_in_map.position_m.head<2>()));
}

} // namespace usar::test
