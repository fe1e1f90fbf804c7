// All that a mission leaves: the height map, the path and the marks, and who made them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/agent/published.h"
#include "core/mapping/raster_export.h"

namespace usar::mission {

/// A plain value that crosses threads. Positions in metres, map frame. The height map itself stays with its session;
/// `raster` is what exports are made from.
struct ScanRecord {
    std::string robot_name;
    std::string behavior_id;
    std::string level;
    Rectangle area_in_map;
    std::vector<agent::MapMark> marks;
    std::vector<Vec3> path_m;
    agent::BehaviorStatus status;
    /// Larger after every change worth saving: map, path, marks, and of the status its words, charges and distance.
    /// While the map is empty nothing is, so it begins at 0 and a cleared record keeps the old one.
    std::uint64_t revision = 0;
    mapping::Raster raster; ///< filled when the record is handed out
};

} // namespace usar::mission
