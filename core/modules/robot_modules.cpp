#include "core/modules/robot_modules.h"

namespace usar::modules {

RobotModules::RobotModules() = default;
RobotModules::~RobotModules() = default;

void RobotModules::take(const protocol::InfoLine& line) {
    state.take(line);
    sensors.take(line, state.now());
    geometry.take(line);
    configuration.take(line);
    responses.take(line);
    if (const auto* const poses = std::get_if<protocol::StartPoses>(&line.message))
        start_poses = *poses;
    else if (const auto* const info = std::get_if<protocol::GameInfo>(&line.message))
        game = *info;
}

} // namespace usar::modules
