// Heights along a line: the terrain under the robot, or under a ruler.
#pragma once

#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/mapping/height_map.h"

namespace usar::mapping {

struct ProfilePoint {
    double distance_m = 0.0;       ///< from the start of the line
    std::optional<float> height_m; ///< the array's; absent where nothing is known
    bool operator==(const ProfilePoint&) const = default;
};

/// Evenly spread points along the straight line, at most a cell apart, ends included; at least two and at most
/// 100 001. Ends that are not finite give none.
std::vector<ProfilePoint> heightProfile(const HeightMap& map, const Vec2& start_m, const Vec2& end_m);

} // namespace usar::mapping
