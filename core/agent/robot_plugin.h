// The SDK's door: what a plugin implements.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QtPlugin>

#include "core/agent/behavior.h"
#include "core/agent/parameters.h"
#include "core/agent/posh_primitive.h"

namespace usar::agent {

/// One way to fly (or drive) the robot.
struct BehaviorDescription {
    std::string id;   ///< "airrobot/cpp"
    std::string name; ///< "Terrain survey (C++)"
    std::string help;
    bool needs_area = false;
    std::vector<ParameterSpec> parameters;
    std::string plan_name = {}; ///< of a behavior that a POSH plan decides: "airrobot.lap"; empty for all others
    std::string plan_text = {}; ///< the plan that comes with the robot
};

struct RobotDescription {
    std::string class_name;                  ///< on the wire: "USARBot.AirRobot"
    std::string name;                        ///< "AirRobot"
    std::vector<std::string> sensors_needed; ///< types on the wire
    std::vector<BehaviorDescription> behaviors;
    std::vector<PrimitiveDescription> primitives =
        {}; ///< what plans may ask of it and have it do; empty where no plan can decide
};

/// What a new behavior is given once.
struct BehaviorContext {
    Task task;
    ParameterSet parameters;
    std::optional<PlanText> plan = {}; ///< in place of the one that comes with the robot
};

/// What a task would come to, shown before it starts: the path over the ground and its cost without obstacles.
struct TaskPreview {
    std::vector<Vec2> path_in_map_m;
    double length_m = 0.0;
    Seconds duration{0.0};
    std::string summary; ///< "6 lanes", "22 lanes in 4 parts"; empty where the behavior has nothing to foretell
};

class RobotPlugin {
public:
    virtual ~RobotPlugin() = default;
    virtual RobotDescription description() const = 0;
    /// An id that `description` does not list is an error, and so is a plan that cannot run on this robot.
    virtual Result<std::unique_ptr<Behavior>> createBehavior(const std::string& id, BehaviorContext context) const = 0;
    /// Quick: called while a person drags the area. An area without size is an error.
    virtual Result<TaskPreview> preview(const std::string& id, const BehaviorContext& context) const;
};

inline Result<TaskPreview> RobotPlugin::preview(const std::string&, const BehaviorContext&) const {
    return TaskPreview{};
}

} // namespace usar::agent

#define USAR_ROBOT_PLUGIN_IID "org.usar.mission.RobotPlugin/4"
Q_DECLARE_INTERFACE(usar::agent::RobotPlugin, USAR_ROBOT_PLUGIN_IID)
