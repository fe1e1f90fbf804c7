#include <algorithm>

#include "core/mission/files/mission_check.h"
#include "core/mission/fleet/fleet_private.h"

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

std::string Fleet::Private::missionNote(const Robot& robot, const StartedBehavior& start) const {
    const RobotView& view = robot.view();
    FlownMission flown;
    Mission& mission = flown.mission;
    mission.name = start.continues ? start.continues->flown.mission.name : start.id;
    mission.world = place.level.toStdString();
    mission.robot_class = view.spawn.class_name;
    mission.start = nameOfStart(start_poses, view.spawn.start_in_map);
    mission.behavior = start.id;
    mission.plan = start.plan ? start.plan->name : std::string();
    mission.area_in_map = start.continues ? start.continues->flown.mission.area_in_map : start.area_in_map;
    mission.parameters = start.parameters;
    mission.cell_size_m = view.cell_size_m;
    mission.isolate = start.isolated;
    flown.seed = seed;
    if (start.continues)
        flown.continues = start.continues->scan.run.recording;
    const agent::BehaviorDescription* const behavior = plugins.behavior(start.id);
    return behavior ? noteOf(flown, behavior->parameters) : std::string();
}

Result<RobotId> Fleet::flyRest(const std::shared_ptr<const RecordedScan>& earlier) {
    const Mission& mission = earlier->flown.mission;
    const std::string recording = earlier->scan.run.recording.toStdString();
    if (const auto possible = checkMission(mission, plugins(), d_->place); !possible)
        return tl::unexpected(possible.error());
    if (earlier->rest_in_map.empty())
        return failure("nothing is left to fly: the whole area was scanned", recording,
                       "Open the recording, then save its map");
    const auto by_name = startPoseOf(mission, {d_->start_poses});
    if (!earlier->start_in_map && !by_name)
        return tl::unexpected(by_name.error());
    const auto id = spawn({mission.robot_class, nextRobotName().toStdString(),
                           earlier->start_in_map ? *earlier->start_in_map : *by_name});
    if (!id)
        return id;
    robot(*id)->setCellSize(mission.cell_size_m);
    d_->rests[*id] = earlier;
    return id;
}

void Fleet::Private::startRest(Robot& robot) {
    const auto found = rests.find(robot.view().id);
    if (found == rests.end() || !robot.view().figures.spawned)
        return;
    const std::shared_ptr<const RecordedScan> earlier = found->second;
    rests.erase(found);
    const Mission& mission = earlier->flown.mission;
    const auto values = checkMission(mission, plugins, place);
    const auto plan = readOwnPlan(QString::fromStdString(mission.plan), mission.behavior, plugins);
    const Result<void> begun =
        !values ? tl::unexpected(values.error())
        : !plan ? tl::unexpected(plan.error())
                : start(robot, {mission.behavior, earlier->rest_in_map, *values, *plan, mission.isolate, earlier});
    if (!begun)
        q.note(Severity::Error, missionKey(robot.view().id), QString::fromStdString(begun.error().text()));
}

} // namespace usar::mission
