#include "core/mission/fleet/station_place.h"

#include <algorithm>

#include "core/protocol/commands/spawn.h"

namespace usar::mission {

SpawnRequest stationRequest(const std::vector<protocol::StartPose>& poses, const std::vector<SpawnRequest>& present) {
    const auto is_free = [&](const protocol::StartPose& pose) {
        return std::ranges::none_of(present, [&](const SpawnRequest& robot) {
            return robot.start_in_map.position_m.isApprox(pose.pose_in_map.position_m);
        });
    };
    auto place = std::ranges::find_if(poses, is_free);
    if (place == poses.end())
        place = poses.begin();
    std::string name = "Base";
    for (int number = 2; std::ranges::count(present, name, &SpawnRequest::robot_name) > 0; ++number)
        name = "Base" + std::to_string(number);
    return {std::string(protocol::station_class), name, place->pose_in_map};
}

} // namespace usar::mission
