#include "core/sim/worlds/start_places.h"

#include <algorithm>
#include <cmath>

#include "core/sim/worlds/building.h"

namespace usar::sim {

NamedPose startOver(const StartPlace& place, double ground_z_m) {
    return {place.name,
            {.position_m = {place.at_m.x(), place.at_m.y(), wholeMillimetres(ground_z_m + spawn_height_m)},
             .yaw_rad = wholeMillimetres(place.yaw_rad)}};
}

void addStarts(World& world, const std::vector<StartPlace>& places) {
    for (const StartPlace& place : places)
        world.start_poses.push_back(startOver(place, world.terrain.height_m(place.at_m)));
}

bool isFarFrom(const std::vector<StartPlace>& places, const Vec2& point_m, double distance_m) {
    return std::ranges::all_of(places,
                               [&](const StartPlace& place) { return (point_m - place.at_m).norm() > distance_m; });
}

Vec2 bestOnGrid(double half_m, double step_m, const std::function<std::optional<double>(const Vec2&)>& score) {
    Vec2 best_m = Vec2::Zero();
    double best = -1e300;
    for (double y = -half_m; y <= half_m; y += step_m)
        for (double x = -half_m; x <= half_m; x += step_m)
            if (const auto value = score({x, y}); value && *value > best) {
                best = *value;
                best_m = {x, y};
            }
    return best_m;
}

double yawToward(const Vec2& from_m, const Vec2& to_m) {
    return std::atan2(to_m.y() - from_m.y(), to_m.x() - from_m.x());
}

} // namespace usar::sim
