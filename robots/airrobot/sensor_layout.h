// Where the AirRobot's sensors sit and how far they see, from the server's answers.
#pragma once

#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/protocol/info/answers.h"

namespace usar::airrobot {

/// One sonar; it looks along its own x axis. `beam_rad` is the full cone.
struct SonarMount {
    std::string name;
    Pose sonar_in_base;
    double maximum_m = 5.0;
    double beam_rad = radians(15.0);
    bool operator==(const SonarMount&) const = default;
};

struct SensorLayout {
    std::vector<SonarMount> sonars; ///< left to right
    std::string scanner_name;       ///< empty: the first one that speaks
    Pose scanner_in_base;
    double scanner_maximum_m = 20.0;
    double maximum_speed_m_s = 2.0;
    double maximum_climb_m_s = 2.0;
    double maximum_turn_rad_s = radians(100.0);
    bool operator==(const SensorLayout&) const = default;
};

/// The stock AirRobot of robots-and-worlds 3.1: nine sonars every 18 degrees on a ring of 0.5 m, the scanner under the
/// belly looking straight down across the track.
SensorLayout stockLayout();

/// Each takes what the answer knows and leaves the rest of `layout` as it is; false where it knew nothing of use.
bool takeSonarGeometry(SensorLayout& layout, const protocol::GeometryInfo& answer);
bool takeSonarLimits(SensorLayout& layout, const protocol::ConfigurationInfo& answer);
bool takeScannerGeometry(SensorLayout& layout, const protocol::GeometryInfo& answer);
bool takeScannerLimits(SensorLayout& layout, const protocol::ConfigurationInfo& answer);
bool takeRobotLimits(SensorLayout& layout, const protocol::ConfigurationInfo& answer);

} // namespace usar::airrobot
