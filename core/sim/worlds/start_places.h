// Where robots start in generated worlds, and how such places are sought.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/geometry.h"
#include "core/sim/world.h"

namespace usar::sim {

/// A place where robots appear; the ground around it is level and open.
struct StartPlace {
    std::string name;
    Vec2 at_m = Vec2::Zero();
    double yaw_rad = 0.0;
};

/// Over the ground: an AirRobot's middle and a little air below.
inline constexpr double spawn_height_m = 0.35;

/// The start pose over ground of this height, in numbers that files keep.
NamedPose startOver(const StartPlace& place, double ground_z_m);

/// The point of a square grid of posts `step_m` apart within +-`half_m` that is highest by `score`; a point without a
/// score is no candidate, the origin is the answer where there is none.
Vec2 bestOnGrid(double half_m, double step_m, const std::function<std::optional<double>(const Vec2&)>& score);

double yawToward(const Vec2& from_m, const Vec2& to_m);

} // namespace usar::sim
