// Where the next base station of the radio network is spawned, and its name.
#pragma once

#include <vector>

#include "core/mission/session/session_orders.h"
#include "core/protocol/info/game_info.h"

namespace usar::mission {

/// Returns a request for a base station at the first start pose at which none of the present robots was spawned, or at
/// the first one if all are taken. Its name is new: "Base", "Base2" and so on. `poses` must not be empty; `present`:
/// how the present robots were spawned.
SpawnRequest stationRequest(const std::vector<protocol::StartPose>& poses, const std::vector<SpawnRequest>& present);

} // namespace usar::mission
