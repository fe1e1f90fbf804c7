#include "core/mission/hand/drive_limits.h"

#include "core/base/text.h"
#include "core/mission/hand/walking_gait.h"
#include "core/protocol/info/configurations.h"

namespace usar::mission {

using protocol::VehicleKind;

namespace {

template <class Number>
void learn(std::optional<Number>& known, const std::optional<Number>& told) {
    if (told && *told > 0.0)
        known = told;
}

/// Reads a steering type. UT2004 writes AckermanSteered, with one n.
DriveStyle styleOf(std::string_view steering) {
    if (sameWord(steering, "SkidSteered"))
        return DriveStyle::Skid;
    if (sameWord(steering, "AckermanSteered") || sameWord(steering, "AckermannSteered"))
        return DriveStyle::Ackermann;
    return DriveStyle::Unknown;
}

} // namespace

void DriveLimits::take(const protocol::InfoMessage& message) {
    if (const auto* const state = std::get_if<protocol::RobotState>(&message))
        takeState(*state);
    else if (const auto* const configuration = std::get_if<protocol::ConfigurationInfo>(&message))
        takeConfiguration(*configuration);
    else if (const auto* const geometry = std::get_if<protocol::GeometryInfo>(&message))
        takeGeometry(*geometry);
}

void DriveLimits::takeState(const protocol::RobotState& state) {
    if (state.kind == kind)
        return;
    kind = state.kind;
    if (kind == VehicleKind::Aerial)
        style = DriveStyle::Aerial;
    else if (kind == VehicleKind::Nautic)
        style = DriveStyle::Nautic;
    else if (kind == VehicleKind::StaticPlatform)
        hindrance = "It is fixed to the ground.";
    else if (kind == VehicleKind::Legged && WalkingGait::fits(state.joints))
        style = DriveStyle::Walker;
    else if (kind == VehicleKind::Legged)
        hindrance = "It walks on legs that no gait is known for; its joints can be moved by typed commands.";
}

void DriveLimits::takeConfiguration(const protocol::ConfigurationInfo& info) {
    const auto robot = protocol::robotConfigurationOf(info);
    if (!robot)
        return;
    configured = true;
    learn(wheel_speed_rad_s, robot->wheel_speed_limit_rad_s);
    learn(front_steer_rad, robot->front_steer_limit_rad);
    learn(rear_steer_rad, robot->rear_steer_limit_rad);
    learn(forward_m_s, robot->forward_limit_m_s);
    learn(sideways_m_s, robot->sideways_limit_m_s);
    learn(climb_m_s, robot->climb_limit_m_s);
    learn(yaw_rate_rad_s, robot->yaw_rate_limit_rad_s);
    const protocol::ConfiguredItem& item = info.items.front();
    learn(propeller_rad_s, item.number("MaxPropellerSpeed"));
    learn(rudder_rad, item.number("MaxRudderAngle"));
    learn(stern_plane_rad, item.number("MaxSternPlaneAngle"));
    if (const DriveStyle steered = styleOf(robot->steering); steered != DriveStyle::Unknown)
        style = steered;
    else if (style == DriveStyle::Unknown && climb_m_s)
        style = DriveStyle::Aerial; // UDK's vehicle does not identify itself as aerial.
    else if (sameWord(robot->steering, "OmniDrive"))
        hindrance = "Each of its wheels is steered by itself, and the server does not say where they are.";
    else
        giveUpAsking();
}

void DriveLimits::takeGeometry(const protocol::GeometryInfo& info) {
    if (info.robot_class.empty())
        return;
    learn(wheel_radius_m, info.wheel_radius_m);
    learn(wheel_separation_m, info.wheel_separation_m);
}

void DriveLimits::giveUpAsking() {
    configured = true;
    if (style != DriveStyle::Unknown || !hindrance.empty())
        return;
    if (kind == VehicleKind::Ground)
        style = DriveStyle::Skid;
    else
        hindrance = "The server does not say what kind of vehicle it is.";
}

StickAxes DriveLimits::axes() const {
    const bool flies = style == DriveStyle::Aerial;
    return {.forward = known(), .left = flies, .turn = known(), .up = flies || style == DriveStyle::Nautic};
}

std::optional<double> DriveLimits::topSpeed_m_s() const {
    if (style == DriveStyle::Aerial)
        return forward_m_s;
    const bool rolls = style == DriveStyle::Skid || style == DriveStyle::Ackermann;
    if (rolls && wheel_speed_rad_s && wheel_radius_m)
        return *wheel_speed_rad_s * *wheel_radius_m;
    return std::nullopt;
}

} // namespace usar::mission
