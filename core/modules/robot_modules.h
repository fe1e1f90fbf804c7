// All modules of one robot, fed together.
#pragma once

#include <optional>

#include "core/modules/query.h"
#include "core/modules/response.h"
#include "core/modules/sensor.h"
#include "core/modules/state.h"

namespace usar::modules {

/// Plain aggregate; whoever owns it feeds it every line of the robot's connection.
struct RobotModules {
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
