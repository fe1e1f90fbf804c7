#include "robots/airrobot/flight/sensor_layout.h"

#include <algorithm>
#include <cmath>

namespace usar::airrobot {

namespace {

bool takePositive(double& target, std::optional<double> number) {
    if (!number || !(*number > 0.0) || !std::isfinite(*number))
        return false;
    target = *number;
    return true;
}

} // namespace

SensorLayout stockLayout() {
    static constexpr double ring_radius_m = 0.5;
    static const char* const names[] = {"L4", "L3", "L2", "L1", "M0", "R1", "R2", "R3", "R4"};
    SensorLayout layout;
    double bearing_rad = radians(72.0);
    for (const char* name : names) {
        const Vec3 position_m(ring_radius_m * std::cos(bearing_rad), ring_radius_m * std::sin(bearing_rad), 0.0);
        layout.sonars.push_back({name, {position_m, 0.0, 0.0, bearing_rad}});
        bearing_rad -= radians(18.0);
    }
    layout.scanner_in_base = {Vec3(0.0, 0.0, -0.1), 0.0, pi / 2.0, 0.0};
    return layout;
}

bool takeSonarGeometry(SensorLayout& layout, const protocol::GeometryInfo& answer) {
    if (answer.items.empty())
        return false;
    layout.sonars.clear();
    for (const protocol::MountedItem& item : answer.items)
        layout.sonars.push_back({item.name, item.item_in_mount});
    std::ranges::sort(layout.sonars, std::greater{},
                      [](const SonarMount& sonar) { return sonar.sonar_in_base.yaw_rad; });
    return true;
}

bool takeSonarLimits(SensorLayout& layout, const protocol::ConfigurationInfo& answer) {
    bool taken = false;
    for (const protocol::ConfiguredItem& item : answer.items) {
        for (SonarMount& sonar : layout.sonars) {
            if (sonar.name != item.name && answer.items.size() > 1)
                continue;
            taken |= takePositive(sonar.maximum_m, item.number("MaxRange"));
            takePositive(sonar.beam_rad, item.number("BeamAngle"));
        }
    }
    return taken;
}

bool takeScannerGeometry(SensorLayout& layout, const protocol::GeometryInfo& answer) {
    if (answer.items.empty())
        return false;
    layout.scanner_name = answer.items.front().name;
    layout.scanner_in_base = answer.items.front().item_in_mount;
    return true;
}

bool takeScannerLimits(SensorLayout& layout, const protocol::ConfigurationInfo& answer) {
    return !answer.items.empty() && takePositive(layout.scanner_maximum_m, answer.items.front().number("MaxRange"));
}

bool takeRobotLimits(SensorLayout& layout, const protocol::ConfigurationInfo& answer) {
    if (answer.items.empty())
        return false;
    const protocol::ConfiguredItem& robot = answer.items.front();
    const bool speed = takePositive(layout.maximum_speed_m_s, robot.number("MaxLinearVelocity"));
    const bool climb = takePositive(layout.maximum_climb_m_s, robot.number("MaxAltitudeVelocity"));
    const bool turn = takePositive(layout.maximum_turn_rad_s, robot.number("MaxRotationalVelocity"));
    return speed || climb || turn;
}

} // namespace usar::airrobot
