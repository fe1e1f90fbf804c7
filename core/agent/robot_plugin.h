// The SDK's door: what a plugin implements.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <QtPlugin>

#include "core/agent/behavior.h"
#include "core/agent/parameters.h"

namespace usar::agent {

/// One way to fly (or drive) the robot.
struct BehaviorDescription {
    std::string id;   ///< "airrobot/cpp"
    std::string name; ///< "Terrain survey (C++)"
    std::string help;
    bool needs_area = false;
    std::vector<ParameterSpec> parameters;
};

struct RobotDescription {
    std::string class_name;                  ///< on the wire: "USARBot.AirRobot"
    std::string name;                        ///< "AirRobot"
    std::vector<std::string> sensors_needed; ///< types on the wire
    std::vector<BehaviorDescription> behaviors;
};

/// What a new behavior is given once.
struct BehaviorContext {
    Task task;
    ParameterSet parameters;
};

class RobotPlugin {
public:
    virtual ~RobotPlugin() = default;
    virtual RobotDescription description() const = 0;
    /// An id that `description` does not list is an error.
    virtual Result<std::unique_ptr<Behavior>> createBehavior(const std::string& id, BehaviorContext context) const = 0;
};

} // namespace usar::agent

#define USAR_ROBOT_PLUGIN_IID "org.usar.mission.RobotPlugin/1"
Q_DECLARE_INTERFACE(usar::agent::RobotPlugin, USAR_ROBOT_PLUGIN_IID)
