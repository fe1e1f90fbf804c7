#include "core/mission/fleet/rests.h"

#include <algorithm>

#include "core/mission/files/mission_check.h"
#include "core/mission/files/plan_file.h"

namespace usar::mission {

namespace {

/// Name of the start pose at this position; that of the first one if there is none.
std::string nameOfStart(const std::vector<protocol::StartPose>& poses, const Pose& start_in_map) {
    const auto found = std::ranges::find_if(poses, [&](const protocol::StartPose& pose) {
        return pose.pose_in_map.position_m.isApprox(start_in_map.position_m);
    });
    return found != poses.end() ? found->name : poses.empty() ? Mission{}.start : poses.front().name;
}

} // namespace

std::string missionNote(const RobotView& robot, const StartedBehavior& start, std::optional<std::uint64_t> seed,
                        const MissionSite& site) {
    const agent::BehaviorDescription* const behavior = site.plugins.behavior(start.id);
    if (!behavior)
        return {};
    FlownMission flown{.mission = {}, .seed = seed};
    Mission& mission = flown.mission;
    mission.name = start.continues ? start.continues->flown.mission.name : start.id;
    mission.world = site.place.level.toStdString();
    mission.robot_class = robot.spawn.class_name;
    mission.start = nameOfStart(site.start_poses, robot.spawn.start_in_map);
    mission.behavior = start.id;
    mission.plan = start.plan ? start.plan->name : std::string();
    mission.area_in_map = start.continues ? start.continues->flown.mission.area_in_map : start.area_in_map;
    mission.parameters = start.parameters;
    mission.cell_size_m = robot.cell_size_m;
    mission.adjust = robot.adjust;
    mission.limit_h = robot.limit_h;
    mission.isolate = start.isolated;
    if (start.continues)
        flown.continues = start.continues->scan.run.recording;
    return noteOf(flown, behavior->parameters);
}

Result<SpawnRequest> spawnRequestFor(const RecordedScan& earlier, const MissionSite& site) {
    const Mission& mission = earlier.flown.mission;
    if (const auto possible = checkMission(mission, site.plugins, site.place); !possible)
        return tl::unexpected(possible.error());
    if (earlier.rest_in_map.empty())
        return failure("nothing is left to fly: the whole area was scanned", earlier.scan.run.recording.toStdString(),
                       "Open the recording, then save its map");
    if (earlier.start_in_map)
        return SpawnRequest{mission.robot_class, {}, *earlier.start_in_map};
    const auto by_name = startPoseOf(mission, {site.start_poses});
    if (!by_name)
        return tl::unexpected(by_name.error());
    return SpawnRequest{mission.robot_class, {}, *by_name};
}

std::optional<Result<StartedBehavior>> Rests::take(const RobotView& robot, const MissionSite& site) {
    const auto found = rests_.find(robot.id);
    if (found == rests_.end() || !robot.figures.spawned)
        return std::nullopt;
    const std::shared_ptr<const RecordedScan> earlier = found->second;
    rests_.erase(found);
    const Mission& mission = earlier->flown.mission;
    const auto values = checkMission(mission, site.plugins, site.place);
    if (!values)
        return tl::unexpected(values.error());
    const auto plan = readOwnPlan(QString::fromStdString(mission.plan), mission.behavior, site.plugins);
    if (!plan)
        return tl::unexpected(plan.error());
    return StartedBehavior{mission.behavior, earlier->rest_in_map, *values, *plan, mission.isolate, earlier};
}

} // namespace usar::mission
