// All modules of one robot, which are fed together.
#pragma once

#include <optional>

#include "core/modules/query.h"
#include "core/modules/response.h"
#include "core/modules/sensor.h"
#include "core/modules/state.h"

namespace usar::modules {

/// Its owner feeds it every line of the robot's connection. Not copyable. Constructed and destroyed out of line to save
/// compile time (see SensorModule).
struct RobotModules {
    RobotModules();
    ~RobotModules();

    StateModule state;
    SensorModule sensors;
    GeometryModule geometry;
    ConfigurationModule configuration;
    ResponseModule responses;
    std::optional<protocol::StartPoses> start_poses; ///< newest answer to GETSTARTPOSES
    std::optional<protocol::GameInfo> game;          ///< newest NFO about the server

    /// Passes the line to all modules, the state first, because its clock stamps sensor readings without a time.
    void take(const protocol::InfoLine& line);
};

} // namespace usar::modules
