// What the robot perceives at one tick, in the map frame of its own drifting estimate.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/cause.h"
#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/modules/robot_modules.h"
#include "robots/airrobot/course_filter.h"
#include "robots/airrobot/pose_history.h"
#include "robots/airrobot/sensor_layout.h"

namespace usar::airrobot {

/// Message tick of UT2004, for which the thesis gave its counts of ticks; a UDK server has ticks of half of it.
inline constexpr Seconds usual_tick{0.2};

/// One sonar's reading. The echo is somewhere on the cone's cap around `center_in_map_m`, between `low_m` and `high_m`.
struct SonarEcho {
    std::string name;
    double bearing_rad = 0.0; ///< in the robot's frame, counter-clockwise
    double range_m = 0.0;
    double maximum_m = 5.0;
    bool hit = false; ///< false: nothing within the range
    Vec3 origin_in_map_m = Vec3::Zero();
    Vec3 center_in_map_m = Vec3::Zero();
    double low_m = 0.0;  ///< map z of the cap's lower and
    double high_m = 0.0; ///< upper edge
};

/// A scan that is new at this tick, placed where the robot was when it was taken.
struct PlacedScan {
    LineNumber line;
    Pose scanner_in_map;
    Pose base_in_map;
    std::vector<Vec3> hits_in_map_m; ///< in beam order, misses left out
};

/// All perception of one tick. Ground truth is not in it: it is looked at only when landed (InsReset).
struct Senses {
    Seconds now{0.0};
    LineNumber line;
    Pose base_in_map; ///< INS, its heading corrected by the course
    Vec3 velocity_in_map_m_s = Vec3::Zero();
    double yaw_rate_rad_s = 0.0;
    std::vector<SonarEcho> sonars;          ///< left to right, those that speak
    std::vector<std::string> silent_sonars; ///< mounted, but without a number for longer than the time-out
    std::optional<PlacedScan> scan;
    std::optional<double> ground_m; ///< map z of what is under the belly: mean of the middle rays ([SD]: ten)
    std::optional<Seconds> robot_battery;
    Seconds ins_age{0.0};   ///< since the last reading of each kind came; huge before the first
    Seconds sonar_age{0.0}; ///< of the sonar that has been silent longest
    Seconds scan_age{0.0};

    Vec3 position_m() const { return base_in_map.position_m; }
    Vec2 position2_m() const { return base_in_map.position_m.head<2>(); }
    double heightOverGround_m(double otherwise_m) const {
        return ground_m ? base_in_map.position_m.z() - *ground_m : otherwise_m;
    }
};

/// Makes senses from the modules' snapshots. Owned by one robot; fed once a tick.
class SenseReader {
public:
    /// A sonar without a number for longer than `time_out` is left out.
    Senses read(Seconds now, LineNumber line, const modules::RobotModules& robot, const SensorLayout& layout,
                Seconds time_out);
    /// The robot's last command, its own frame: what the course is compared with. Never told: no correction.
    void tellCommand(const Vec2& velocity_in_base_m_s) { commanded_m_s_ = velocity_in_base_m_s; }
    /// The estimate has jumped.
    void forgetMotion();

private:
    /// The last line of one sonar that held a number, and when it came.
    struct Heard {
        LineNumber line;
        Seconds at{0.0};
    };

    void readSonars(Senses& senses, const modules::RobotModules& robot, const SensorLayout& layout, Seconds time_out);
    void readScan(Senses& senses, const modules::RobotModules& robot, const SensorLayout& layout);

    PoseHistory history_;
    CourseFilter course_;
    Vec2 commanded_m_s_ = Vec2::Zero();
    Pose base_in_map_;
    LineNumber last_ins_;
    LineNumber last_scan_;
    std::optional<Seconds> ins_seen_;
    std::optional<Seconds> scan_seen_;
    std::map<std::string, Heard, std::less<>> sonars_heard_;
    std::optional<double> ground_m_;
};

} // namespace usar::airrobot
