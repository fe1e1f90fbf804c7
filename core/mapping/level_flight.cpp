#include "core/mapping/level_flight.h"

#include <algorithm>
#include <cmath>

namespace usar::mapping {

namespace {

constexpr Seconds window{1.2};
constexpr Seconds half_window{0.55};
constexpr double steady_turn_rad_s = 0.1;
constexpr double steady_climb_m_s = 0.4;
constexpr double steady_m_s2 = 0.2;
/// A robot that goes to and fro has hardly begun to move when it leans the other way.
constexpr double steady_lean_rad = 0.07;
constexpr double slowest_m_s = 0.3; ///< Slower, the robot may stand on the ground or hold against something.
/// Noise of each change of an angle, as a share of it.
constexpr double walk_share = 0.05;
/// The wire has two decimals, so an angle that was set is wrong by up to 0.005 rad.
constexpr double set_variance_rad2 = 0.003 * 0.003;
/// One reading has this variance from rounding and from accelerations that pass for steady flight.
constexpr double reading_variance_rad2 = 0.008 * 0.008;
constexpr double outlier_sigmas2 = 16.0;
/// So many readings in a row that no drift explains are no chance.
constexpr int surprising_outliers = 15;
constexpr int most_surprises = 2;
constexpr double largest_jump_rad = 0.1;
/// The rounding of the wire stays the same while an angle does, so that many equal readings are no better than this.
constexpr double least_variance_rad2 = 0.003 * 0.003;

} // namespace

void LevelFlight::insWasSet() {
    recent_.clear();
    steady_ = false;
    calm_ = true;
    steady_outliers_ = surprises_ = 0;
    drift_rad_.setZero();
    variance_rad2_.setConstant(set_variance_rad2);
}

const LevelFlight::Estimate* LevelFlight::before(Seconds age) const {
    for (auto estimate = recent_.rbegin(); estimate != recent_.rend(); ++estimate)
        if (recent_.back().time - estimate->time >= age)
            return &*estimate;
    return nullptr;
}

void LevelFlight::take(Seconds now, const Pose& base_in_map) {
    if (!base_in_map.position_m.allFinite() || !base_in_map.rotation().coeffs().allFinite() ||
        (!recent_.empty() && now <= recent_.back().time))
        return;
    if (!recent_.empty()) {
        const Pose& last = recent_.back().base_in_map;
        const Vec2 turned_rad(normalizedAngle(base_in_map.roll_rad - last.roll_rad),
                              normalizedAngle(base_in_map.pitch_rad - last.pitch_rad));
        variance_rad2_ += walk_share * walk_share * turned_rad.cwiseAbs2();
    }
    recent_.push_back({now, base_in_map});
    while (recent_.size() > 2 && now - recent_[1].time >= window)
        recent_.pop_front();
    const auto velocity_m_s = steadyVelocity_m_s();
    steady_ = velocity_m_s.has_value();
    if (!steady_)
        return;
    velocity_m_s_ = *velocity_m_s;
    if (calm_)
        learn(Vec2(base_in_map.roll_rad, base_in_map.pitch_rad) - lean_rad());
}

std::optional<Vec2> LevelFlight::steadyVelocity_m_s() const {
    const Estimate* const oldest = before(2.0 * half_window);
    const Estimate* const middle = before(half_window);
    if (!oldest || !middle || oldest == middle)
        return std::nullopt;
    const Estimate& newest = recent_.back();
    const double late_s = (newest.time - middle->time).count();
    const double early_s = (middle->time - oldest->time).count();
    const Vec3 late_m_s = (newest.base_in_map.position_m - middle->base_in_map.position_m) / late_s;
    const Vec3 early_m_s = (middle->base_in_map.position_m - oldest->base_in_map.position_m) / early_s;
    const double turn_rad = normalizedAngle(newest.base_in_map.yaw_rad - oldest->base_in_map.yaw_rad);
    const Vec2 mean_m_s = (late_m_s + early_m_s).head<2>() / 2.0;
    const bool leans_steadily = std::ranges::all_of(recent_, [&](const Estimate& one) {
        return std::abs(normalizedAngle(one.base_in_map.roll_rad - newest.base_in_map.roll_rad)) < steady_lean_rad &&
               std::abs(normalizedAngle(one.base_in_map.pitch_rad - newest.base_in_map.pitch_rad)) < steady_lean_rad;
    });
    if (std::abs(turn_rad) > steady_turn_rad_s * (late_s + early_s) ||
        std::max(std::abs(late_m_s.z()), std::abs(early_m_s.z())) > steady_climb_m_s ||
        (late_m_s - early_m_s).head<2>().norm() > steady_m_s2 * (late_s + early_s) / 2.0 ||
        mean_m_s.norm() < slowest_m_s || !leans_steadily)
        return std::nullopt;
    return Vec2(Eigen::Rotation2Dd(-newest.base_in_map.yaw_rad) * mean_m_s);
}

Vec2 LevelFlight::lean_rad() const {
    return velocity_m_s_.norm() / (free_fall_m_s * free_fall_m_s) * Vec2(-velocity_m_s_.y(), velocity_m_s_.x());
}

void LevelFlight::learn(const Vec2& shown_rad) {
    bool outlier = false;
    for (int angle = 0; angle < 2; ++angle) {
        const double error_rad = shown_rad[angle] - drift_rad_[angle];
        const double variance_rad2 = variance_rad2_[angle] + reading_variance_rad2;
        if (error_rad * error_rad > outlier_sigmas2 * variance_rad2) {
            outlier = true;
            continue;
        }
        const double gain = variance_rad2_[angle] / variance_rad2;
        drift_rad_[angle] += gain * error_rad;
        variance_rad2_[angle] = std::max(least_variance_rad2, (1.0 - gain) * variance_rad2_[angle]);
    }
    steady_outliers_ = outlier ? steady_outliers_ + 1 : 0;
    if (steady_outliers_ < surprising_outliers)
        return;
    const Vec2 jump_rad = shown_rad - drift_rad_;
    steady_outliers_ = 0;
    calm_ = ++surprises_ <= most_surprises && jump_rad.cwiseAbs().maxCoeff() < largest_jump_rad;
    variance_rad2_ += jump_rad.cwiseAbs2();
}

double LevelFlight::doubt_rad() const {
    return std::sqrt(variance_rad2_.maxCoeff());
}

Pose LevelFlight::corrected(const Pose& base_in_map) const {
    Pose level = base_in_map;
    if (!calm_)
        return level;
    level.roll_rad = steady_ ? lean_rad().x() : level.roll_rad - drift_rad_.x();
    level.pitch_rad -= drift_rad_.y();
    return level;
}

} // namespace usar::mapping
