// Places where robots start in generated worlds, and how they are found.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/sim/world/world.h"

namespace usar::sim {

/// A place where robots appear; the ground around it is level and open.
struct StartPlace {
    std::string name;
    Vec2 at_m = Vec2::Zero();
    double yaw_rad = 0.0;
};

/// Height of a start pose above the ground, which leaves a little air below an AirRobot's legs.
inline constexpr double spawn_height_m = 0.35;

/// The start pose above ground of this height, rounded to numbers that files keep exactly.
NamedPose startOver(const StartPlace& place, double ground_z_m);
/// Adds start poses above the world's terrain.
void addStarts(World& world, const std::vector<StartPlace>& places);
/// True if the point is farther than `distance_m` from every one of the places.
bool isFarFrom(const std::vector<StartPlace>& places, const Vec2& point_m, double distance_m);

/// The point with the highest `score` on a square grid of posts `step_m` apart within +-`half_m`. A point without a
/// score is not a candidate; if there is none, the result is the origin.
Vec2 bestOnGrid(double half_m, double step_m, const std::function<std::optional<double>(const Vec2&)>& score);

/// Yaw of a robot at `from_m` that faces `to_m`.
double yawToward(const Vec2& from_m, const Vec2& to_m);

} // namespace usar::sim
