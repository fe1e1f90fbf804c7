// The interface that a robot plugin implements, and the entry point of the SDK. A plugin is a Qt plugin library with
// one class:
//
//     class MyRobot : public QObject, public RobotPlugin {
//         Q_OBJECT
//         Q_PLUGIN_METADATA(IID USAR_ROBOT_PLUGIN_IID FILE "my_robot.json")
//         Q_INTERFACES(usar::agent::RobotPlugin)
//
// Its JSON file is described at PluginLoader.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QtPlugin>

#include "core/agent/behavior.h"
#include "core/agent/parameters.h"
#include "core/agent/posh/posh_primitive.h"
#include "core/base/time_range.h"

namespace usar::agent {

/// One behavior of the robot.
struct BehaviorDescription {
    std::string id;   ///< "airrobot/cpp"
    std::string name; ///< "Terrain survey (C++)"
    std::string help;
    bool needs_area = false; ///< the task must have a mission area
    std::vector<ParameterSpec> parameters;
    std::string plan_name = {};                ///< "airrobot.lap" if a POSH plan decides; empty otherwise
    std::string plan_text = {};                ///< the plan that comes with the robot
    std::vector<ParameterPreset> presets = {}; ///< their values fit `parameters`
};

/// A robot and its behaviors.
struct RobotDescription {
    std::string class_name;                  ///< class on the wire: "USARBot.AirRobot"
    std::string name;                        ///< "AirRobot"
    std::vector<std::string> sensors_needed; ///< types on the wire
    std::vector<BehaviorDescription> behaviors;
    std::vector<PrimitiveDescription> primitives = {}; ///< senses and acts for plans; empty if no behavior uses a plan
};

/// The arguments for the creation of a behavior.
struct BehaviorContext {
    Task task;
    ParameterSet parameters;
    std::optional<PlanText> plan = {}; ///< replaces the plan that comes with the robot
};

/// The ranges of what a task will probably take and reach, between good and bad ground.
struct TaskOutlook {
    TimeRange duration;
    int least_sorties = 1; ///< take-offs from the base
    int most_sorties = 1;
    double least_coverage_pct = 0.0; ///< share of the area that the map will show, 0 to 100
    double most_coverage_pct = 100.0;
    bool operator==(const TaskOutlook&) const = default;
};

/// The path over the ground and the cost of a task, without obstacles, shown before the task starts.
struct TaskPreview {
    std::vector<Vec2> path_in_map_m;
    double length_m = 0.0;
    Seconds duration{0.0};
    std::string summary; ///< "6 lanes", "22 lanes in 4 parts"; empty if the behavior has no preview
    std::optional<TaskOutlook> outlook = {};
};

/// A robot's plugin. It must be immutable once loaded: `createBehavior` may be called in any thread.
class RobotPlugin {
public:
    virtual ~RobotPlugin() = default;
    /// The robot and its behaviors; their ids must equal those in the plugin's metadata.
    virtual RobotDescription description() const = 0;
    /// Returns an error if `description` does not list the id, or if the plan cannot run on this robot.
    virtual Result<std::unique_ptr<Behavior>> createBehavior(const std::string& id, BehaviorContext context) const = 0;
    /// Must be quick, because it is called while the user drags the area. Returns an error if a needed area is empty.
    virtual Result<TaskPreview> preview(const std::string&, const BehaviorContext&) const { return TaskPreview{}; }
};

} // namespace usar::agent

/// The number is the version of this interface; plugins built for another version are rejected.
#define USAR_ROBOT_PLUGIN_IID "org.usar.mission.RobotPlugin/9"
Q_DECLARE_INTERFACE(usar::agent::RobotPlugin, USAR_ROBOT_PLUGIN_IID)
