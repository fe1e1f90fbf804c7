// Tasks that the user has set up for each robot, started or not.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/agent/parameters.h"
#include "core/base/geometry.h"
#include "core/base/robot_id.h"
#include "core/mission/files/mission_file.h"

namespace usar::mission {

/// A task as entered in the forms of the window.
struct TaskDraft {
    std::string behavior_id;                             ///< empty: none is chosen
    std::string plan_path;                               ///< the user's own POSH plan; empty: the robot's
    std::optional<Rectangle> area_in_map;                ///< meters; absent: not drawn yet
    std::map<std::string, agent::ParameterValue> values; ///< SI units and radians
    double cell_size_m = Mission{}.cell_size_m;          ///< edge of a height map cell
    bool adjust = false;                                 ///< correct the height map where its strips overlap
    std::optional<double> limit_h;   ///< hours of simulated time that the behavior may run; absent: none
    std::vector<std::string> faults; ///< faults for the embedded simulator, as texts
    bool operator==(const TaskDraft&) const = default;

    /// The drawn area, or an empty one.
    Rectangle area() const { return area_in_map.value_or(Rectangle{}); }
    /// Chooses a behavior. If it is a different one, plan and values are cleared, because they belong to the old one.
    void choose(const std::string& behavior);
    /// Takes over what a mission file says. `values`: its parameters in SI units and radians.
    void take(const Mission& mission, const std::map<std::string, agent::ParameterValue>& values);
    /// Returns the mission that carries out this task; its name, world, robot, start pose and isolation are left to the
    /// caller.
    Mission mission() const;
};

/// One draft for each robot, by robot id, and one under id 0 for the robot that is spawned next. A plain value.
class TaskDrafts {
public:
    /// The draft of the robot that is shown.
    TaskDraft& shown() { return drafts_[shown_]; }
    const TaskDraft& shown() const;
    RobotId shownRobot() const { return shown_; }
    /// The draft of any robot; one that has none gets an empty one.
    TaskDraft& of(RobotId robot) { return drafts_[robot]; }
    /// Shows another robot's draft. A robot without a draft starts from the one that was shown before.
    void show(RobotId robot);
    /// Copies the draft of a replayed robot to its replay. With `from` 0 (no such robot) the area is left out.
    void copy(RobotId from, RobotId to);
    void forget(RobotId robot) { drafts_.erase(robot); }
    /// Clears the areas of all drafts; call it when the world changes, because they refer to the old one.
    void forgetAreas();

private:
    std::map<RobotId, TaskDraft> drafts_{{RobotId{}, {}}};
    RobotId shown_;
};

} // namespace usar::mission
