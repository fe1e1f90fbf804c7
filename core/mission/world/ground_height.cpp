#include "core/mission/world/ground_height.h"

#include <limits>

namespace usar::mission {

double groundHeight_m(const GroundSources& sources, const Vec2& at_m) {
    if (sources.terrain_m)
        if (const auto height_m = sources.terrain_m(at_m))
            return *height_m;
    if (sources.tiles)
        if (const auto probe = mapping::probeHeight(*sources.tiles, sources.cell_size_m, at_m))
            return double(probe->height_m);
    double z_m = 0.0;
    double nearest_m = std::numeric_limits<double>::infinity();
    for (const protocol::StartPose& pose : sources.start_poses)
        if (const double d = (pose.pose_in_map.position_m.head<2>() - at_m).norm(); d < nearest_m) {
            nearest_m = d;
            z_m = pose.pose_in_map.position_m.z();
        }
    return z_m;
}

} // namespace usar::mission
