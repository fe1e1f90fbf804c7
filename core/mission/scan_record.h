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
    /// What was made to go wrong meanwhile, in words: "60.2 s: fault begins: wind speed=5".
    std::vector<std::string> faults;
    /// Larger after every change worth saving: map, path, marks, and of the status its words, charges and distance.
    /// While the map is empty nothing is, so it begins at 0 and a cleared record keeps the old one.
    std::uint64_t revision = 0;
    mapping::Raster raster; ///< filled when the record is handed out
    /// Parts of the map too far from the rest to be in one raster with it: saved as raw heights, in no picture.
    std::vector<mapping::Raster> far_rasters;
    std::size_t cells_left_out = 0; ///< known, but in too many far places to be saved
};

/// Of the raster and the far ones.
inline std::size_t knownCellCount(const ScanRecord& record) {
    std::size_t count = record.raster.knownCellCount();
    for (const mapping::Raster& far : record.far_rasters)
        count += far.knownCellCount();
    return count;
}

} // namespace usar::mission
