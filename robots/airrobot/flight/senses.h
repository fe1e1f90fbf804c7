// The perception of the robot in one tick, in the map frame of its own drifting pose estimate.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/cause.h"
#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/protocol/usual_values.h"

namespace usar::airrobot {

/// The tick of messages in UT2004, on which the thesis based its counts of ticks. Ticks of a UDK server are half as
/// long.
inline constexpr Seconds usual_tick{0.2};

/// The reading of one sonar. The echo comes from somewhere on the cone's cap around `center_in_map_m`, between the
/// heights `low_m` and `high_m`.
struct SonarEcho {
    std::string name;
    double bearing_rad = 0.0; ///< direction of the sonar in the robot's frame, counterclockwise
    double range_m = 0.0;
    double maximum_m = protocol::usual_sonar_maximum_m;
    bool hit = false; ///< false if nothing is within the maximum range
    /// The place of the sonar, and that of the echo if it came from the middle of the cone.
    Vec3 origin_in_map_m = Vec3::Zero();
    Vec3 center_in_map_m = Vec3::Zero();
    double low_m = 0.0;  ///< map z of the lower edge of the cap
    double high_m = 0.0; ///< map z of its upper edge
};

/// A scan that is new in this tick, placed where the robot was when it was taken.
struct PlacedScan {
    LineNumber line; ///< line of the protocol that contained it
    Pose scanner_in_map;
    Pose base_in_map;
    /// In beam order, without beams that hit nothing. In steady flight, a robot that corrects its lean (SenseReader)
    /// places them without the drift of the INS's roll and pitch, which is in both poses.
    std::vector<Vec3> hits_in_map_m;
    /// Map z of the highest point that a beam surely reached, be it that it hit something there or that its range
    /// ended: always without that drift, if it is known, and less two standard deviations of what is not known of it.
    double highest_m = -1e9;
    /// The same within 10 m of the robot, measured level.
    double highest_near_m = -1e9;
    /// False if the roll and pitch of the INS may have drifted unnoticed, so that these heights are wrong by meters.
    bool lean_known = true;
    std::vector<Vec3> misses_in_map_m{}; ///< where the range of the beams ended that hit nothing
    /// The same as `scanner_in_map`, without the drift of the INS's roll and pitch as far as it is known: for the map.
    Pose level_scanner_in_map{};
};

/// Lower than this over the ground, sonars may hear the ground instead of walls.
inline constexpr double sure_of_walls_m = 2.5;

/// All perceptions of one tick, in SI units; places and heights are in the map frame, ages on the protocol clock.
/// Ground truth is among them only where a person has the robot navigate by it. Otherwise InsReset alone uses it, on
/// the ground.
struct Senses {
    Seconds now{0.0};
    LineNumber line;
    Pose base_in_map;    ///< from the INS, with the heading corrected by the course; or from ground truth
    Pose level_in_map{}; ///< the same without the drift of the INS's roll and pitch, as far as it is known
    /// Velocity over ground from the last INS readings; 0 after a jump of the position estimate.
    Vec3 velocity_in_map_m_s = Vec3::Zero();
    /// How far the height in `base_in_map` may be wrong by now; 0 if it comes from ground truth.
    double height_doubt_m = 0.0;
    /// Positive to the left.
    double yaw_rate_rad_s = 0.0;
    double ins_yaw_rate_rad_s = 0.0;        ///< the same without the jumps that corrections of the heading make
    std::vector<SonarEcho> sonars;          ///< left to right, without silent ones
    std::vector<SonarEcho> glimpses;        ///< what sonars have heard close by in this tick only, see SonarCheck
    std::vector<std::string> silent_sonars; ///< mounted sonars that have sent no number for longer than the timeout
    std::optional<PlacedScan> scan;         ///< nullopt if there is no new scan in this tick
    std::optional<double> ground_m; ///< map z of the ground under the belly, the mean of the middle rays ([SD]: ten);
                                    ///< nullopt if too few hit it
    std::optional<Seconds> robot_battery; ///< remaining time of the robot's own battery; nullopt if not reported
    /// The last pose leans so differently from the one before it that it is not used.
    bool leans_beyond_belief = false;
    Seconds ins_age{0.0};   ///< time since the last INS reading; huge before the first
    Seconds sonar_age{0.0}; ///< the same for the sonar that has been silent the longest
    Seconds scan_age{0.0};  ///< the same for the scanner
    Seconds late{0.0};      ///< The robot obeys so much later than usual, see LinkWatch.

    /// What is left of the gain of a control loop, so that a late link does not make it swing: a loop is steady while
    /// its gain times its delay is small. The robot itself takes half a second to obey.
    double steadyShare() const { return 0.5 / (0.5 + late.count()); }

    /// The estimated position, map frame; the second form is horizontal.
    Vec3 position_m() const { return base_in_map.position_m; }
    Vec2 position2_m() const { return base_in_map.position_m.head<2>(); }
    /// The height over the ground below, or `otherwise_m` if the ground is not visible.
    double heightOverGround_m(double otherwise_m) const {
        return ground_m ? base_in_map.position_m.z() - *ground_m : otherwise_m;
    }
};

} // namespace usar::airrobot
