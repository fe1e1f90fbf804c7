#include "robots/airrobot/flight/pilot.h"

#include <algorithm>
#include <cmath>

#include "robots/airrobot/flight/steering.h"

namespace usar::airrobot {

namespace {

/// Limit of the ramp's time, so that the robot does not accelerate abruptly after a gap in the messages.
constexpr Seconds longest_ramp = 2 * usual_tick;
/// A command may get lost on its way, and the robot would obey the one before it as long as nothing changes.
constexpr Seconds repeat_after{1.0};
constexpr double turn_gain_per_s = 1.4;
constexpr double stop_to_turn_rad = 0.6;
constexpr double sonars_hear_rad = radians(80.0); ///< from the nose to either side
constexpr double firm_braking_m_s2 = 2.0;
constexpr double hold_gain_per_s = 0.6;
constexpr double hold_speed_m_s = 0.5;
constexpr double hold_tolerance_m = 0.15;
constexpr double drift_gain_per_s = 0.35;
constexpr double largest_drift_m_s = 1.5;
constexpr double most_at_once_m_s = 2.0; ///< A greater error is a leap of the pose.
constexpr double much_slower_m_s = 0.25; ///< It is slower by less in calm air after it has sped up and turned.
constexpr double felt_wind_m_s = 0.4;    ///< Less may come from speeding up and turning in calm air.
constexpr double late_way_m = 1.2;       ///< On a late link, it is so slow that it stands within this distance.

Vec2 limited(const Vec2& vector, double length) {
    const double norm = vector.norm();
    return norm > length ? Vec2(vector * (length / norm)) : vector;
}

} // namespace

double turnRate_rad_s(const Senses& senses, double bearing_rad, const Settings& settings) {
    const double error_rad = normalizedAngle(bearing_rad - senses.base_in_map.yaw_rad);
    const double fastest_rad_s = senses.steadyShare() * settings.turn_rate_rad_s;
    return std::clamp(senses.steadyShare() * turn_gain_per_s * error_rad, -fastest_rad_s, fastest_rad_s);
}

Motion toward(const Senses& senses, double bearing_rad, double speed_m_s, const Settings& settings, Corner corner) {
    const double error_rad = std::abs(normalizedAngle(bearing_rad - senses.base_in_map.yaw_rad));
    const double stop_rad = corner == Corner::Round ? sonars_hear_rad : stop_to_turn_rad;
    const double part = std::max(0.0, 1.0 - error_rad / stop_rad);
    return {.velocity_in_map_m_s = speed_m_s * part * Vec2(std::cos(bearing_rad), std::sin(bearing_rad)),
            .yaw_rate_rad_s = turnRate_rad_s(senses, bearing_rad, settings)};
}

Motion holding(const Senses& senses, const Vec2& place_m) {
    Motion motion;
    const Vec2 error_m = place_m - senses.position2_m();
    if (error_m.norm() > hold_tolerance_m)
        motion.velocity_in_map_m_s = limited(senses.steadyShare() * hold_gain_per_s * error_m, hold_speed_m_s);
    return motion;
}

Motion calmed(Motion motion, const Senses& senses, const Settings& settings) {
    if (senses.late <= Seconds{0.0})
        return motion;
    const double most_m_s = stoppingSpeed_m_s(late_way_m, settings.braking_m_s2, (reaction + senses.late).count());
    const double most_rad_s = senses.steadyShare() * settings.turn_rate_rad_s;
    motion.velocity_in_map_m_s = limited(motion.velocity_in_map_m_s, most_m_s);
    motion.climb_m_s *= senses.steadyShare();
    motion.yaw_rate_rad_s = std::clamp(motion.yaw_rate_rad_s, -most_rad_s, most_rad_s);
    return motion;
}

Seconds Pilot::rampTime(Seconds now) {
    const Seconds since_last = last_at_ && now >= *last_at_ ? now - *last_at_ : usual_tick;
    last_at_ = now;
    return std::min(since_last, longest_ramp);
}

void Pilot::fly(const Motion& motion, const Senses& senses, agent::CommandPort& port, const std::string& source,
                const Settings& settings) {
    const Vec2 change_m_s = motion.velocity_in_map_m_s - commanded_m_s_;
    const bool slower = motion.velocity_in_map_m_s.norm() < commanded_m_s_.norm();
    const double rate_m_s2 = slower ? firm_braking_m_s2 : settings.acceleration_m_s2;
    const double ramp_s = rampTime(senses.now).count();
    // A sudden motion takes its time, which is not the wind's doing, and an old velocity is that of another moment.
    if (!motion.sudden && senses.ins_age <= Seconds{0.0})
        learnDrift(senses, ramp_s);
    commanded_m_s_ =
        motion.sudden ? motion.velocity_in_map_m_s : commanded_m_s_ + limited(change_m_s, rate_m_s2 * ramp_s);
    send(motion, senses, port, source);
}

void Pilot::send(const Motion& motion, const Senses& senses, agent::CommandPort& port, const std::string& source) {
    const double cosine = std::cos(senses.base_in_map.yaw_rad);
    const double sine = std::sin(senses.base_in_map.yaw_rad);
    const Vec2 through_air_m_s = limited(commanded_m_s_ - drift_m_s_, fastest_m_s_);
    const protocol::AerialDrive drive{.climb_m_s = motion.climb_m_s,
                                      .forward_m_s = cosine * through_air_m_s.x() + sine * through_air_m_s.y(),
                                      .left_m_s = -sine * through_air_m_s.x() + cosine * through_air_m_s.y(),
                                      .yaw_rate_rad_s = motion.yaw_rate_rad_s};
    wanted_in_base_m_s_ = {cosine * commanded_m_s_.x() + sine * commanded_m_s_.y(),
                           -sine * commanded_m_s_.x() + cosine * commanded_m_s_.y()};
    const bool is_fresh = sent_at_ && senses.now - *sent_at_ < repeat_after;
    if (last_ == drive && is_fresh)
        return;
    last_ = drive;
    sent_at_ = senses.now;
    port.send(drive, source);
}

void Pilot::brace(const Senses& senses, double climb_m_s, agent::CommandPort& port, const std::string& source) {
    commanded_m_s_ = Vec2::Zero();
    last_at_.reset();
    if (senses.late > Seconds{0.0})
        drift_m_s_ = Vec2::Zero(); // It may be its own motion of a moment ago.
    send({.climb_m_s = climb_m_s}, senses, port, source);
}

bool Pilot::feelsWind() const {
    return drift_m_s_.norm() >= felt_wind_m_s;
}

protocol::AerialDrive Pilot::still(const Senses& senses) const {
    protocol::AerialDrive drive{0.0, 0.0, 0.0, 0.0};
    if (!feelsWind() || senses.late > Seconds{0.0})
        return drive;
    const Vec2 in_base_m_s = Eigen::Rotation2Dd(-senses.base_in_map.yaw_rad) * -limited(drift_m_s_, fastest_m_s_);
    drive.forward_m_s = in_base_m_s.x();
    drive.left_m_s = in_base_m_s.y();
    return drive;
}

void Pilot::learnDrift(const Senses& senses, double dt_s) {
    const Vec2 moves_m_s = senses.velocity_in_map_m_s.head<2>();
    Vec2 error_m_s = moves_m_s - commanded_m_s_;
    // A robot that cannot fly as fast as it is to be is slower by its own limit, too, and not by the wind alone.
    if (error_m_s.norm() > much_slower_m_s)
        error_m_s = moves_m_s - (limited(commanded_m_s_ - drift_m_s_, fastest_m_s_) + drift_m_s_);
    error_m_s = limited(error_m_s, most_at_once_m_s);
    drift_m_s_ = limited(drift_m_s_ + senses.steadyShare() * drift_gain_per_s * dt_s * error_m_s, largest_drift_m_s);
}

void Pilot::stop(agent::CommandPort& port, const std::string& source) {
    commanded_m_s_ = drift_m_s_ = wanted_in_base_m_s_ = Vec2::Zero();
    last_at_.reset();
    const protocol::AerialDrive zero{0.0, 0.0, 0.0, 0.0};
    if (last_ == zero)
        return;
    last_ = zero;
    port.send(zero, source);
}

} // namespace usar::airrobot
