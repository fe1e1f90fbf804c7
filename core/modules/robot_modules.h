// All modules of one robot, fed together.
#pragma once

#include <optional>

#include "core/modules/query.h"
#include "core/modules/response.h"
#include "core/modules/sensor.h"
#include "core/modules/state.h"

namespace usar::modules {

/// Whoever owns it feeds it every line of the robot's connection. Not copied: made and cleared in one place, for the
/// compiler's sake (see SensorModule).
struct RobotModules {
    RobotModules();
    ~RobotModules();

    StateModule state;
    SensorModule sensors;
    GeometryModule geometry;
    ConfigurationModule configuration;
    ResponseModule responses;
    std::optional<protocol::StartPoses> start_poses;
    std::optional<protocol::GameInfo> game;

    void take(const protocol::InfoLine& line);
};

} // namespace usar::modules
