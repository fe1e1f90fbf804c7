// Writes the equipment of our robots into the configuration file of a real USARSim server.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/protocol/dialect.h"
#include "core/sim/robots/robot_model.h"

namespace usar::sim {

/// A file for a server, and what it cannot say.
struct ServerText {
    std::string text;
    /// One sentence for each sensor or setting of a robot file that the server cannot have.
    std::vector<std::string> left_out;
};

/// Writes the sensors of all robots that this server knows. Where robots want different settings of one class of
/// sensors, the AirRobot's count, or else those of the first robot.
ServerText writeServerFile(const RobotCatalog& robots, protocol::Dialect dialect);

/// Puts the same into a server's own file and keeps everything else: the lines of other sensors, of parts and joints.
/// A robot that has neither camera nor mission package loses those of the server. Where the server's file has a sensor
/// of one of our names, its class is taken for all sensors of this type, unless it is another type's. Fails if there is
/// no robot in the file, or if one of ours stands there in Unreal units.
Result<ServerText> mergeServerFile(std::string_view server_text, const RobotCatalog& robots, protocol::Dialect dialect);

} // namespace usar::sim
