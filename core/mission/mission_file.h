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

/// "FILE:LINE:COLUMN" of a key in the file and of its value.
struct KeyPlace {
    std::string key;
    std::string value;
    bool operator==(const KeyPlace&) const = default;
};

/// A mission as it is written down. Keys of the file: name, world, robot, start, behavior, plan (file of a POSH plan in
/// place of the one that comes with the robot; a relative path begins at the mission's folder), area {x, y, width,
/// height} (lowest corner and size, metres, map frame: x forward, y left; width along x), parameters {}, cell_size_m,
/// faults [] (texts, as the simulator's --fault takes them; their times count from the beginning of the mission),
/// isolate (true: the behavior runs in a process of its own). Only the name must be there, and an area where the
/// behavior needs one. Angles in the file are degrees where the parameter's unit is rad.
struct Mission {
    std::string name;
    std::string world = "tall_test";
    std::string robot_class = "USARBot.AirRobot";
    std::string start = "PlayerStart"; ///< name of a start pose
    std::string behavior = "airrobot/cpp";
    std::string plan;                                        ///< path; empty: the robot's own
    Rectangle area_in_map;                                   ///< empty: none
    std::map<std::string, agent::ParameterValue> parameters; ///< as written; see `withAnglesInRadians`
    double cell_size_m = 0.25;                               ///< 0.02 .. 10
    std::vector<std::string> faults;                         ///< of the embedded simulator
    bool isolate = false;                                    ///< the behavior has a process of its own
    /// By path ("area.width", "parameters.scan_altitude_m"), for what is found wrong only later. Empty where no file
    /// was read; whoever puts another value in takes the place of the old one out.
    std::map<std::string, KeyPlace> places;
};

/// Errors name file, line and column: broken JSON, an unknown key (with the nearest known one), a key given twice or
/// missing, a wrong type, an area without size.
Result<Mission> readMission(const QByteArray& json, const QString& file_name);
Result<Mission> readMissionFile(const QString& path);

/// The error with the place in the file of this key, or of its value, put before it; unchanged where that is unknown.
Error atKey(const Mission& mission, const std::string& path, const Error& error);
Error atValue(const Mission& mission, const std::string& path, const Error& error);

/// The file's parameters as a behavior takes them: those whose spec says "rad" turned from degrees to radians.
std::map<std::string, agent::ParameterValue>
withAnglesInRadians(std::map<std::string, agent::ParameterValue> parameters,
                    const std::vector<agent::ParameterSpec>& specs);

} // namespace usar::mission
