#include "core/mission/hand/stick_drive.h"

#include <algorithm>
#include <cmath>

namespace usar::mission {

namespace {

/// Used if CONF gives no limit: an angle that the wheels of a car can reach at least.
constexpr double cautious_angle_rad = 0.3;
constexpr double cautious_turn_share = 0.4; ///< share of the wheels' speed
constexpr double whole_pct = 100.0;

/// How much faster the right wheels run than the robot at full turn, as a share of their highest speed.
double turnShare(const DriveLimits& limits) {
    if (!limits.wheel_speed_rad_s || !limits.wheel_radius_m || !limits.wheel_separation_m)
        return cautious_turn_share;
    const double spin_rad_s = most_yaw_rate_rad_s * *limits.wheel_separation_m / 2.0 / *limits.wheel_radius_m;
    return std::min(1.0, spin_rad_s / *limits.wheel_speed_rad_s);
}

protocol::SkidDrive skidDrive(const DriveLimits& limits, const Stick& stick, double speed_share) {
    const double forward = stick.forward * speed_share;
    // The square root keeps turns possible at low speed.
    const double turn = stick.turn * turnShare(limits) * std::sqrt(speed_share);
    const double most = std::max(1.0, std::abs(forward) + std::abs(turn));
    const double whole = limits.wheel_speed_rad_s.value_or(whole_pct) / most;
    return {.left_rad_s = whole * (forward - turn),
            .right_rad_s = whole * (forward + turn),
            .normalized = !limits.wheel_speed_rad_s};
}

protocol::AckermannDrive ackermannDrive(const DriveLimits& limits, const Stick& stick, double speed_share) {
    return {.speed_rad_s = stick.forward * speed_share * limits.wheel_speed_rad_s.value_or(whole_pct),
            .front_steer_rad = stick.turn * limits.front_steer_rad.value_or(cautious_angle_rad),
            .rear_steer_rad = 0.0,
            .normalized = !limits.wheel_speed_rad_s};
}

protocol::AerialDrive aerialDrive(const DriveLimits& limits, const Stick& stick, double speed_share) {
    const bool learnt = limits.forward_m_s && limits.sideways_m_s && limits.climb_m_s && limits.yaw_rate_rad_s;
    const auto term = [&](double share, const std::optional<double>& limit) {
        return share * speed_share * (learnt ? *limit : whole_pct);
    };
    return {.climb_m_s = term(stick.up, limits.climb_m_s),
            .forward_m_s = term(stick.forward, limits.forward_m_s),
            .left_m_s = term(stick.left, limits.sideways_m_s),
            .yaw_rate_rad_s = term(stick.turn, limits.yaw_rate_rad_s),
            .normalized = !learnt};
}

/// On the wire, a positive rudder turns the nose to the right, and a positive stern plane lifts it.
protocol::NauticDrive nauticDrive(const DriveLimits& limits, const Stick& stick, double speed_share) {
    const bool learnt = limits.propeller_rad_s && limits.rudder_rad && limits.stern_plane_rad;
    const auto whole = [&](const std::optional<double>& limit) { return learnt ? *limit : whole_pct; };
    return {.propeller_rad_s = stick.forward * speed_share * whole(limits.propeller_rad_s),
            .rudder_rad = -stick.turn * whole(limits.rudder_rad),
            .stern_plane_rad = stick.up * whole(limits.stern_plane_rad),
            .normalized = !learnt};
}

} // namespace

std::optional<protocol::Command> driveOf(const DriveLimits& limits, const Stick& stick, double speed_share) {
    const Stick asked = masked(clamped(stick), limits.axes());
    const double share = std::clamp(speed_share, 0.0, 1.0);
    switch (limits.style) {
    case DriveStyle::Aerial:
        return aerialDrive(limits, asked, share);
    case DriveStyle::Skid:
        return skidDrive(limits, asked, share);
    case DriveStyle::Ackermann:
        return ackermannDrive(limits, asked, share);
    case DriveStyle::Nautic:
        return nauticDrive(limits, asked, share);
    case DriveStyle::Walker:
    case DriveStyle::Unknown:
        break;
    }
    return std::nullopt;
}

Stick StickShaper::follow(const Stick& asked, Seconds dt) {
    const double most = std::max(0.0, dt.count()) / rise.count();
    const auto follow = [most](double now, double wanted) {
        const double from = now * wanted > 0.0 ? now : 0.0; // A change of direction begins at rest.
        if (std::abs(wanted) <= std::abs(from))
            return wanted;
        return from + std::clamp(wanted - from, -most, most);
    };
    const Stick to = clamped(asked);
    now_ = {follow(now_.forward, to.forward), follow(now_.left, to.left), follow(now_.turn, to.turn),
            follow(now_.up, to.up)};
    return now_;
}

} // namespace usar::mission
