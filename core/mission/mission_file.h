// MISSION.json: what to fly, where, and how.
#pragma once

#include <map>
#include <string>

#include <QByteArray>
#include <QString>

#include "core/agent/parameters.h"
#include "core/base/geometry.h"
#include "core/base/result.h"

namespace usar::mission {

/// A mission as it is written down. Angles in the file are degrees where the parameter's unit is rad.
struct Mission {
    std::string name;
    std::string world = "tall_test";
    std::string robot_class = "USARBot.AirRobot";
    std::string start = "PlayerStart"; ///< name of a start pose
    std::string behavior = "airrobot/cpp";
    Rectangle area_in_map;
    std::map<std::string, agent::ParameterValue> parameters;
    double cell_size_m = 0.25;
};

/// Errors name file, line and column: broken JSON, an unknown or missing key, a wrong type, an area without size.
Result<Mission> readMission(const QByteArray& json, const QString& file_name);
Result<Mission> readMissionFile(const QString& path);

} // namespace usar::mission
