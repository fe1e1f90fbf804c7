// Converts what only the embedded simulator knows to the values that missions are scored by.
#pragma once

#include <functional>
#include <memory>

#include "core/mission/runs/mission_score.h"
#include "core/mission/runs/run_summary.h"
#include "core/server/embedded/headless_simulator.h"
#include "core/sim/rays/ray_caster.h"
#include "core/sim/world/free_space.h"
#include "core/sim/world/world.h"

namespace usar::app {

/// True heights of the simulator's world. The functions are valid as long as the simulator.
inline mission::Truth truthOf(const server::HeadlessSimulator& simulator) {
    return {.surface_m = [&simulator](const Vec2& point_m) { return simulator.surface_m(point_m); },
            .ground_m = [&simulator](const Vec2& point_m) { return simulator.ground_m(point_m); },
            .world_in_map = simulator.extent(),
            .reach = [&simulator](const FlightLimits& flight,
                                  const Rectangle& area_in_map) { return simulator.reach(flight, area_in_map); }};
}

/// Makes the true heights of a world; made in the caller's thread, which may take a moment.
inline std::function<mission::Truth()> truthMakerOf(const std::shared_ptr<const sim::World>& world) {
    return [world] {
        const auto caster = std::make_shared<const sim::RayCaster>(*world);
        return mission::Truth{
            .surface_m = [world, caster](const Vec2& point_m) { return caster->surface_m(point_m); },
            .ground_m = [world](const Vec2& point_m) { return world->terrain.height_m(point_m); },
            .world_in_map = sim::extentOf(*world),
            .reach = [world](const FlightLimits& flight,
                             const Rectangle& area_in_map) { return sim::reachFrom(*world, flight, area_in_map); }};
    };
}

/// Copies all figures; the height over ground is absent for a robot that has not dived.
inline mission::TrueFigures trueFiguresOf(const sim::RobotTruth& robot) {
    std::optional<mission::HeightOverGround> height;
    if (robot.height)
        height = {robot.height->least_m, robot.height->mean_m, robot.height->spread_m};
    return {robot.collisions,
            robot.distance_m,
            robot.longest_stay,
            robot.falls,
            robot.touches,
            robot.first_touch,
            height,
            robot.broken,
            robot.powered_for,
            std::nullopt,
            robot.collision_places_in_map_m};
}

/// The same for the first robot of the simulator, also after it has left; nullopt if there was none. Waits for the
/// simulator's thread.
inline std::optional<mission::TrueFigures> trueFiguresOf(const server::HeadlessSimulator& simulator) {
    const auto robot = simulator.firstRobot();
    return robot ? std::optional(trueFiguresOf(*robot)) : std::nullopt;
}

} // namespace usar::app
