// The mission file (MISSION.json): what to fly, where, and how; it is read, and written so that the mission can be
// flown again.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QByteArray>
#include <QString>

#include "core/agent/parameters.h"
#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/base/result.h"
#include "core/mission/files/claim.h"

namespace usar::mission {

/// Places of a key and of its value in the file, as "FILE:LINE:COLUMN".
struct KeyPlace {
    std::string key;
    std::string value;
    bool operator==(const KeyPlace&) const = default;
};

inline constexpr double smallest_cell_m = 0.02;
inline constexpr double largest_cell_m = 10.0;
inline constexpr double shortest_limit_h = 1e-6;
inline constexpr double longest_limit_h = 1e4;

/// A mission as written in its file. Keys of the file: name, world, robot, start, behavior, plan (file of a POSH plan
/// to use instead of the robot's own; a relative path begins at the mission's folder), area {x, y, width, height}
/// (lowest corner and size, meters, map frame: x forward, y left; width along x), preset (of the behavior's parameters,
/// by its id), parameters {} (what differs from the preset, or from the defaults), cell_size_m, limit_h
/// (hours of simulated time after which the behavior is ended), faults [] (texts, as for the simulator's --fault; their
/// times count from the beginning of the mission), isolate (true: the behavior runs in a process of its own), adjust
/// (true: the height map is corrected where its strips overlap), seed (of the embedded simulator, a whole number),
/// claims [] (what a test of the flight checks, see readClaims: the mission is then stopped as soon as they are
/// decided, and they alone say whether it has succeeded). Only the name is required, and an area if the behavior needs
/// one. Angles in the file are in degrees if the parameter's unit is rad.
struct Mission {
    std::string name;
    std::string world = "tall_test";
    std::string robot_class = "USARBot.AirRobot";
    std::string start = "PlayerStart"; ///< name of a start pose
    std::string behavior = "airrobot/cpp";
    std::string plan;                                        ///< path of a plan file; empty: the robot's own plan
    Rectangle area_in_map;                                   ///< meters; empty: none
    std::string preset;                                      ///< id of a preset; empty: none, which means the defaults
    std::map<std::string, agent::ParameterValue> parameters; ///< as written; see `resolvedParameters`
    double cell_size_m = 0.25;                               ///< smallest_cell_m .. largest_cell_m
    std::optional<double> limit_h;                           ///< shortest_ .. longest_limit_h; absent: no limit
    std::vector<std::string> faults;                         ///< for the embedded simulator, in its --fault syntax
    bool isolate = false;                                    ///< the behavior runs in a process of its own
    bool adjust = false;                                     ///< see ScanBook::setAdjust
    std::optional<std::uint64_t> seed;                       ///< of the embedded simulator; absent: any
    std::vector<Claim> claims;
    /// Places in the file by path ("area.width", "parameters.scan_altitude_m"), for errors that are found later. Empty
    /// if no file was read. Code that replaces a value must also remove its place.
    std::map<std::string, KeyPlace> places;
};

/// Reads a mission from JSON text; `file_name` is used in errors and for relative paths. Errors name file, line and
/// column: broken JSON, an unknown key (with the nearest known one), a key given twice or missing, a wrong type, an
/// area without size.
Result<Mission> readMission(const QByteArray& json, const QString& file_name);
/// Reads a mission file of at most 1 MiB.
Result<Mission> readMissionFile(const QString& path);

/// Returns the error with the place in the file of this key, or of its value, as its `where`; the former `where` moves
/// into the text. Unchanged if the place is unknown.
Error atKey(const Mission& mission, const std::string& path, const Error& error);
Error atValue(const Mission& mission, const std::string& path, const Error& error);

/// Returns the file's parameters in a behavior's units: those whose spec says "rad" converted from degrees to radians.
std::map<std::string, agent::ParameterValue>
withAnglesInRadians(std::map<std::string, agent::ParameterValue> parameters,
                    const std::vector<agent::ParameterSpec>& specs);

/// Returns the degrees that the user typed, without the rounding error of the conversion to radians: 90 and not
/// 89.99..9.
double typedDegrees(double angle_rad);

/// Returns the time on the protocol clock that a behavior may run; infinite without a limit.
Seconds limitFrom(const std::optional<double>& limit_h);

/// Returns JSON that `readMission` accepts, ending with a newline. Values in `mission` are in a behavior's units: those
/// whose spec says "rad" are written in degrees. Reading the text and converting the angles back gives the same
/// mission, except for reals with whole values, which the file cannot distinguish from integers and a behavior accepts
/// as either. The path of a plan is written as an absolute path, or as a relative one if it is inside `folder`, the
/// folder of the mission.
QByteArray writeMission(const Mission& mission, const std::vector<agent::ParameterSpec>& specs,
                        const QString& folder = {});

/// Writes the mission file completely or not at all; an error names path and reason.
Result<void> writeMissionFile(const Mission& mission, const std::vector<agent::ParameterSpec>& specs,
                              const QString& path);

} // namespace usar::mission
