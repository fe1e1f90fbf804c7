// What the user has set up for each robot and may not have started yet.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/agent/parameters.h"
#include "core/base/geometry.h"
#include "core/mission/files/mission_file.h"

namespace usar::mission {

/// A task as it stands in the forms of the window.
struct TaskDraft {
    std::string behavior_id;                             ///< empty: none is chosen
    std::string plan_path;                               ///< the user's own POSH plan; empty: the robot's
    std::optional<Rectangle> area_in_map;                ///< absent: not drawn yet
    std::map<std::string, agent::ParameterValue> values; ///< SI units and radians
    double cell_size_m = Mission{}.cell_size_m;          ///< of the height map
    std::vector<std::string> faults;                     ///< of the embedded simulator, as texts
    bool operator==(const TaskDraft&) const = default;

    /// The drawn area, or an empty one.
    Rectangle area() const { return area_in_map.value_or(Rectangle{}); }
    /// Another behavior was chosen: plan and values were the other one's.
    void choose(const std::string& behavior);
    /// Takes over what a mission file says. `values`: its parameters in SI units and radians.
    void take(const Mission& mission, const std::map<std::string, agent::ParameterValue>& values);
    /// The mission that flies this; its name, world, robot, start pose and isolation are left to the caller.
    Mission mission() const;
};

/// One draft for each robot, by its id, and one under 0 for the robot that is spawned next. A plain value.
class TaskDrafts {
public:
    /// The draft of the robot that is shown.
    TaskDraft& shown() { return drafts_[shown_]; }
    const TaskDraft& shown() const;
    /// Shows another robot's draft. A robot without a draft starts from the one that was shown before.
    void show(int robot);
    /// A replay starts from the draft of the robot that it replays (0: of none, and then without an area).
    void copy(int from, int to);
    void forget(int robot) { drafts_.erase(robot); }
    /// Another world: rectangles of the old one mean nothing there.
    void forgetAreas();

private:
    std::map<int, TaskDraft> drafts_{{0, {}}};
    int shown_ = 0;
};

} // namespace usar::mission
