// The height of the ground, from whoever knows it best.
#pragma once

#include "core/mission/fleet/robot.h"
#include "core/mission/world/world_edits.h"

namespace usar::mission {

/// From the embedded world (`terrain_m`, which may be empty), else from what `scanning` has scanned (nullptr: nobody),
/// else a guess from the start poses. Meters in the map frame.
inline double knownGround_m(const Vec2& at_m, const decltype(GroundSources::terrain_m)& terrain_m,
                            const Robot* scanning, const std::vector<protocol::StartPose>& start_poses) {
    GroundSources sources{.terrain_m = terrain_m, .start_poses = start_poses};
    if (scanning) {
        sources.tiles = &scanning->view().tiles;
        sources.cell_size_m = scanning->view().cell_size_m;
    }
    return groundHeight_m(sources, at_m);
}

} // namespace usar::mission
