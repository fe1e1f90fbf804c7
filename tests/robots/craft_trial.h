// A craft without a flight around it: what it hears over flat ground, and what it commands.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robots/airrobot/flight/craft.h"

namespace usar::test {

using namespace usar::airrobot;

/// Hovers at `x_m` and `z_m` in an estimate that the tests move. Call `begin` for each test.
struct CraftTrial {
    std::optional<modules::RobotModules> robot;
    agent::CommandPort port;
    SensorLayout layout;
    std::uint64_t line = 0;
    double now_s = 0.0;
    double x_m = 0.0;
    double y_m = 0.0;
    double z_m = 20.0;
    double yaw_rad = 0.0;
    double roll_rad = 0.0;
    double pitch_rad = 0.0;
    bool tells_pose = true;
    std::unique_ptr<Craft> craft;

    void begin() {
        robot.emplace();
        port = {};
        layout = stockLayout();
        line = 0;
        now_s = 100.0;
        x_m = y_m = 0.0;
        z_m = 20.0;
        yaw_rad = roll_rad = pitch_rad = 0.0;
        tells_pose = true;
        craft = std::make_unique<Craft>();
    }

    void tell(protocol::InfoMessage message) { robot->take({LineNumber{++line}, "", std::move(message), {}}); }

    /// One tick over flat ground `height_m` below, with these sonars nearer than 5 m; the scanner's level rays see what
    /// stands `left_m` and `right_m` beside.
    void perceive(double height_m, const std::map<std::string, double>& near_m, double left_m = 20.0,
                  double right_m = 20.0) {
        now_s += 0.2;
        protocol::SonarReadings sonars;
        for (const SonarMount& mount : layout.sonars)
            sonars.ranges.push_back({mount.name, near_m.contains(mount.name) ? near_m.at(mount.name) : 5.0});
        tell(sonars);
        protocol::RangeScan scan{Seconds(now_s), "Scanner1", radians(1.0), pi, std::vector<double>(181, 20.0)};
        for (std::size_t i = 0; i < scan.ranges_m.size(); ++i)
            if (const double down = std::cos(scan.beamAngle_rad(i)); down > height_m / 20.0)
                scan.ranges_m[i] = (height_m - 0.1) / down;
        scan.ranges_m.front() = right_m;
        scan.ranges_m.back() = left_m;
        tell(scan);
        if (tells_pose)
            tell(protocol::InsReading{{}, "INS", Pose{Vec3(x_m, y_m, z_m), roll_rad, pitch_rad, yaw_rad}});
        protocol::RobotState state;
        state.time = Seconds(now_s);
        tell(state);
        craft->perceive({Seconds(now_s), LineNumber{line}, *robot}, layout, true, port);
    }
    /// The sonars that hear trunks at these places (map x and y), and from how near.
    std::map<std::string, double> hearing(const std::vector<Vec2>& trunks_m) const {
        std::map<std::string, double> near_m;
        for (const Vec2& trunk_m : trunks_m)
            for (const SonarMount& mount : layout.sonars) {
                const Vec2 sonar_m =
                    Vec2(x_m, y_m) + Eigen::Rotation2Dd(yaw_rad) * mount.sonar_in_base.position_m.head<2>();
                const double bearing_rad = bearingOf(trunk_m - sonar_m) - yaw_rad - mount.sonar_in_base.yaw_rad;
                const double range_m = (trunk_m - sonar_m).norm();
                if (range_m < mount.maximum_m && std::abs(normalizedAngle(bearing_rad)) < mount.beam_rad / 2.0)
                    near_m[mount.name] = near_m.contains(mount.name) ? std::min(near_m[mount.name], range_m) : range_m;
            }
        return near_m;
    }
    /// Moves as the last command says for one tick.
    void move(const protocol::AerialDrive& drive) {
        const Vec2 in_base_m_s(drive.forward_m_s.value_or(0.0), drive.left_m_s.value_or(0.0));
        const Vec2 moved_m = Eigen::Rotation2Dd(yaw_rad) * (0.2 * in_base_m_s);
        x_m += moved_m.x();
        y_m += moved_m.y();
        z_m += 0.2 * drive.climb_m_s.value_or(0.0);
        yaw_rad = normalizedAngle(yaw_rad + 0.2 * drive.yaw_rate_rad_s.value_or(0.0));
    }
    protocol::AerialDrive fly(double speed_m_s = 1.0) {
        craft->fly({Vec2(x_m + 30, 0), Vec2(x_m + 8, 0), speed_m_s, "test"}, port);
        return lastDrive().value_or(protocol::AerialDrive{});
    }
    /// The last DRIVE since the last call, among questions about the link; nullopt if there is none.
    std::optional<protocol::AerialDrive> lastDrive() {
        std::optional<protocol::AerialDrive> last;
        for (const agent::CausedCommand& caused : port.takeCommands())
            if (const auto* const drive = std::get_if<protocol::AerialDrive>(&caused.command))
                last = *drive;
        return last;
    }
};

} // namespace usar::test
