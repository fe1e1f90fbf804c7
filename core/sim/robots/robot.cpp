#include "core/sim/robots/robot.h"

#include "core/base/text.h"
#include "core/sim/robots/air_robot.h"

namespace usar::sim {

Result<std::unique_ptr<Robot>> spawnRobot(std::string_view class_name, const RobotSurroundings& surroundings,
                                          const RobotOptions& options) {
    const std::string_view bare_name = class_name.substr(class_name.rfind('.') + 1);
    if (!sameWord(bare_name, "AirRobot"))
        return failure("unknown robot class", std::string(class_name), "This server has USARBot.AirRobot");
    return AirRobot::spawn(surroundings, options);
}

} // namespace usar::sim
