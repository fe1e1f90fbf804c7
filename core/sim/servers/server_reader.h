// Reads the equipment of robots back from the configuration file of a real USARSim server, and compares it with our
// robot files.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/result.h"
#include "core/protocol/dialect.h"
#include "core/sim/robots/robot_model.h"

namespace usar::sim {

/// A sensor or camera of a robot on a server.
struct ServerItem {
    std::string class_name; ///< "USARBot.SonarSensor"
    std::string name;
    std::string parent; ///< the part that carries it; empty: the chassis
    Pose item_in_parent;
};

struct ServerRobot {
    std::string class_name; ///< without "USARBot."
    std::vector<ServerItem> items;
    Numbers numbers; ///< batteryLife, msgTimer …, by their names in small letters
};

/// What a server's file says.
struct ServerFile {
    protocol::Dialect dialect = protocol::Dialect::Ut2004;
    std::vector<ServerRobot> robots;
    /// By class and name, both in small letters; a True is 1.
    std::map<std::string, Numbers> settings;

    const ServerRobot* robot(std::string_view class_name) const;
};

/// Reads a file of either dialect. Fails if it has no robot.
Result<ServerFile> readServerFile(std::string_view text);

/// One sentence for each sensor that the server's robot lacks or has elsewhere than ours, and for each of its settings
/// that differs from ours. A sensor is known by its name and its class; positions count to a millimeter, angles to a
/// milliradian.
std::vector<std::string> differencesOf(const RobotModel& ours, const ServerFile& server);

} // namespace usar::sim
