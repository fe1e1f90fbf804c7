// MISSION.json: what to fly, where, and how.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <QByteArray>
#include <QString>

#include "core/agent/parameters.h"
#include "core/base/geometry.h"
#include "core/base/result.h"

namespace usar::mission {

/// A mission as it is written down. Keys of the file: name, world, robot, start, behavior, area {x, y, width, height}
/// (lowest corner and size, metres, map frame: x forward, y left; width along x), parameters {}, cell_size_m. Only
/// name and area must be there. Angles in the file are degrees where the parameter's unit is rad.
struct Mission {
    std::string name;
    std::string world = "tall_test";
    std::string robot_class = "USARBot.AirRobot";
    std::string start = "PlayerStart"; ///< name of a start pose
    std::string behavior = "airrobot/cpp";
    Rectangle area_in_map;
    std::map<std::string, agent::ParameterValue> parameters; ///< as written; see `withAnglesInRadians`
    double cell_size_m = 0.25;                               ///< 0.02 .. 10
};

/// Errors name file, line and column: broken JSON, an unknown key (with the nearest known one), a key given twice or
/// missing, a wrong type, an area without size.
Result<Mission> readMission(const QByteArray& json, const QString& file_name);
Result<Mission> readMissionFile(const QString& path);

/// The file's parameters as a behavior takes them: those whose spec says "rad" turned from degrees to radians.
std::map<std::string, agent::ParameterValue>
withAnglesInRadians(std::map<std::string, agent::ParameterValue> parameters,
                    const std::vector<agent::ParameterSpec>& specs);

} // namespace usar::mission
