// What real servers call the sensors and settings of our robot files; resources/docs/real-server.md says how sure each
// name is.
#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text.h"
#include "core/protocol/dialect.h"
#include "core/sim/robots/robot_model.h"

namespace usar::sim {

/// A setting of a sensor: in our robot files, and in the section of its class on a server.
struct ServerSetting {
    std::string_view ours;   ///< "beam_angle"
    std::string_view theirs; ///< "BeamAngle"
};

/// The server's class for each type of sensor ("Sonar": "USARBot.SonarSensor").
using SensorClasses = std::map<std::string, std::string, std::less<>>;

/// The classes of a stock server. Types that it does not have, or whose class is unknown, are left out; so are the
/// encoders of UT2004, which hang on parts that only the server's own file names.
SensorClasses stockClasses(protocol::Dialect dialect);

/// False if a stock server has this class for another type of sensor; a class of a server's own may be of any type.
inline bool mayHaveClass(std::string_view type, std::string_view class_name, const SensorClasses& stock) {
    const auto found =
        std::ranges::find_if(stock, [class_name](const auto& known) { return sameWord(known.second, class_name); });
    return found == stock.end() || sameWord(found->first, type);
}

/// The settings of this type of sensor that the server's file has. A server keeps one value for all sensors of a class.
std::vector<ServerSetting> settingsOf(std::string_view type, protocol::Dialect dialect);

/// False for a robot that is known to be on servers of the other dialect only.
bool isOnServer(std::string_view class_name, protocol::Dialect dialect);

/// The key of the list in a robot's section that names a sensor of this type: Sensors, Cameras or AddParts.
std::string_view listKeyOf(std::string_view type, protocol::Dialect dialect);

/// "USARBot.ini" or "DefaultUSAR.ini".
std::string_view serverFileName(protocol::Dialect dialect);

} // namespace usar::sim
