#include "core/mission/files/task_drafts.h"

namespace usar::mission {

void TaskDraft::choose(const std::string& behavior) {
    if (behavior == behavior_id)
        return;
    behavior_id = behavior;
    plan_path.clear();
    values.clear();
}

void TaskDraft::take(const Mission& mission, const std::map<std::string, agent::ParameterValue>& mission_values) {
    behavior_id = mission.behavior;
    plan_path = mission.plan;
    area_in_map = mission.area_in_map;
    values = mission_values;
    cell_size_m = mission.cell_size_m;
    adjust = mission.adjust;
    limit_h = mission.limit_h;
    faults = mission.faults;
}

Mission TaskDraft::mission() const {
    Mission mission;
    mission.behavior = behavior_id;
    mission.plan = plan_path;
    mission.area_in_map = area();
    mission.parameters = values;
    mission.cell_size_m = cell_size_m;
    mission.adjust = adjust;
    mission.limit_h = limit_h;
    mission.faults = faults;
    return mission;
}

const TaskDraft& TaskDrafts::shown() const {
    static const TaskDraft none;
    const auto found = drafts_.find(shown_);
    return found == drafts_.end() ? none : found->second;
}

void TaskDrafts::show(RobotId robot) {
    if (!drafts_.contains(robot))
        drafts_[robot] = shown();
    shown_ = robot;
}

void TaskDrafts::copy(RobotId from, RobotId to) {
    const auto found = drafts_.find(from);
    drafts_[to] = found == drafts_.end() ? TaskDraft{} : found->second;
    if (!from.valid())
        drafts_[to].area_in_map.reset();
}

void TaskDrafts::forgetAreas() {
    for (auto& [robot, draft] : drafts_)
        draft.area_in_map.reset();
}

} // namespace usar::mission
