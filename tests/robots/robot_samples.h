// Senses made by hand for the tests of the AirRobot's building blocks.
#pragma once

#include "robots/airrobot/flight/obstacle_memory.h"
#include "robots/airrobot/flight/senses.h"
#include "robots/airrobot/flight/sensor_layout.h"

namespace usar::test {

/// At `position_m`, level, six metres over flat ground, nothing within the sonars' range.
inline airrobot::Senses sensesAt(const Vec3& position_m, double yaw_rad = 0.0, double now_s = 100.0) {
    airrobot::Senses senses;
    senses.now = Seconds(now_s);
    senses.line = {42};
    senses.base_in_map = senses.level_in_map = {position_m, 0.0, 0.0, yaw_rad};
    senses.ground_m = position_m.z() - 6.0;
    return senses;
}

/// The echo of the stock sonar `name` at `range_m`; 5 m is no echo.
inline airrobot::SonarEcho echoOf(const airrobot::Senses& senses, const std::string& name, double range_m) {
    airrobot::SonarEcho echo;
    for (const airrobot::SonarMount& mount : airrobot::stockLayout().sonars) {
        if (mount.name != name)
            continue;
        const Pose sonar_in_map = senses.base_in_map * mount.sonar_in_base;
        echo = {name,
                mount.sonar_in_base.yaw_rad,
                range_m,
                5.0,
                range_m < 4.98,
                sonar_in_map.position_m,
                sonar_in_map * Vec3(range_m, 0.0, 0.0)};
        echo.low_m = echo.center_in_map_m.z() - 0.13 * range_m;
        echo.high_m = echo.center_in_map_m.z() + 0.13 * range_m;
    }
    return echo;
}

/// All nine sonars; those in `ranges` read less than 5 m.
inline void setSonars(airrobot::Senses& senses, const std::vector<std::pair<std::string, double>>& ranges) {
    senses.sonars.clear();
    for (const airrobot::SonarMount& mount : airrobot::stockLayout().sonars) {
        double range_m = 5.0;
        for (const auto& [name, value_m] : ranges)
            range_m = name == mount.name ? value_m : range_m;
        senses.sonars.push_back(echoOf(senses, mount.name, range_m));
    }
}

/// A scan with hits at this height on a grid around `center_m`.
inline void setFlatScan(airrobot::Senses& senses, const Vec2& center_m, double half_side_m, double height_m) {
    airrobot::PlacedScan scan{senses.line, senses.base_in_map, senses.base_in_map, {}};
    for (double y = -half_side_m; y <= half_side_m; y += 0.25)
        for (double x = -half_side_m; x <= half_side_m; x += 0.25)
            scan.hits_in_map_m.emplace_back(center_m.x() + x, center_m.y() + y, height_m);
    senses.scan = scan;
}

inline airrobot::Obstacle wallAt(double x_m, double y_m, double top_m = 100.0, bool known = false) {
    return {Vec2(x_m, y_m), top_m, known};
}

} // namespace usar::test
