// The mounting and the reach of the AirRobot's sensors, from the server's answers.
#pragma once

#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/protocol/info/answers.h"
#include "core/protocol/usual_values.h"

namespace usar::airrobot {

/// One sonar, which looks along its own x axis.
struct SonarMount {
    std::string name;
    /// The place of the sonar in the robot's frame. The yaw is its bearing, counterclockwise.
    Pose sonar_in_base;
    double maximum_m = protocol::usual_sonar_maximum_m; ///< reach
    double beam_rad = radians(15.0);                    ///< full angle of the cone
    bool operator==(const SonarMount&) const = default;
};

/// The sensors and the limits of a robot.
struct SensorLayout {
    std::vector<SonarMount> sonars; ///< left to right
    std::string scanner_name;       ///< empty means the first scanner that sends readings
    /// The place of the scanner in the robot's frame.
    Pose scanner_in_base;
    double scanner_maximum_m = protocol::usual_scanner_maximum_m; ///< reach of the scanner
    double maximum_speed_m_s = 2.0;                               ///< horizontal speed
    double maximum_climb_m_s = 2.0;                               ///< vertical speed, up and down
    double maximum_turn_rad_s = radians(100.0);
    bool operator==(const SensorLayout&) const = default;
};

/// Returns the stock AirRobot of robots-and-worlds.md 3.1: nine sonars, every 18 degrees on a ring with a radius of 0.5
/// m, and the scanner under the belly, which looks straight down across the direction of flight.
SensorLayout stockLayout();

/// Each of these stores the values of an answer in `layout` and leaves the rest unchanged. Returns false if the answer
/// has no usable value.
/// Replaces all sonars by those of the answer, sorted from left to right. Limits are back at their defaults, so ask for
/// the geometry before the limits.
bool takeSonarGeometry(SensorLayout& layout, const protocol::GeometryInfo& answer);
/// "MaxRange" and "BeamAngle" of each sonar by name; a single item counts for all sonars.
bool takeSonarLimits(SensorLayout& layout, const protocol::ConfigurationInfo& answer);
/// Name and mount of the first scanner, and its "MaxRange".
bool takeScannerGeometry(SensorLayout& layout, const protocol::GeometryInfo& answer);
bool takeScannerLimits(SensorLayout& layout, const protocol::ConfigurationInfo& answer);
/// "MaxLinearVelocity", "MaxAltitudeVelocity" and "MaxRotationalVelocity". Values that are not positive and finite do
/// not count, here and above.
bool takeRobotLimits(SensorLayout& layout, const protocol::ConfigurationInfo& answer);

} // namespace usar::airrobot
