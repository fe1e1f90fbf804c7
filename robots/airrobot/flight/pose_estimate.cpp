#include "robots/airrobot/flight/pose_estimate.h"

#include <algorithm>
#include <cmath>

namespace usar::airrobot {

namespace {

/// Growth of the variance per radian of turn, which is (1.1 degrees)^2 per right angle.
constexpr double turn_variance_rad = 2.4e-4;
/// Variance of a step's velocity as a share of its square: 5 % of the step, plus what the autopilot does not correct.
constexpr double course_variance = 0.0036;
constexpr double rounding_m_s = 0.02; ///< The two decimals of the protocol make a velocity wrong by about this.
constexpr double steady_m_s = 0.12;
constexpr Seconds shortest_interval{0.15};
constexpr Seconds longest_interval{1.0};
constexpr int steady_ticks_needed = 6;
constexpr double straight_rad = 0.02;
constexpr double outlier_sigmas2 = 16.0;
/// So many outliers in a row come from another wind, or from something that holds the robot.
constexpr int surprising_steps = 10;
constexpr double limit_rad = 0.4;
/// The wind's standard deviation where nothing is known of it: the autopilot corrects most of what blows.
constexpr double any_wind_m_s = 1.0;
constexpr double next_flight_m_s = 0.1; ///< The wind may have changed by this after a rest.
/// In calm air, the estimate changes by this within a second. Wind of more than `calm_m_s` has gusts, and carries the
/// robot aside by another share of its speed with each direction of the flight.
constexpr double calm_change_m_s = 0.0003;
constexpr double calm_m_s = 0.05;
constexpr double gust_share = 0.3;
constexpr double turn_share = 0.6; ///< per right angle

double between(double from_rad, double to_rad, double part) {
    return normalizedAngle(from_rad + part * normalizedAngle(to_rad - from_rad));
}

} // namespace

void PoseHistory::add(Seconds time, const Pose& base_in_map) {
    if (!poses_.empty() && time <= poses_.back().time) {
        poses_.back().pose = base_in_map;
        return;
    }
    poses_.push_back({time, base_in_map});
    while (poses_.size() > 2 && poses_.front().time < time - span_)
        poses_.pop_front();
}

std::optional<Pose> PoseHistory::at(Seconds time) const {
    if (poses_.empty())
        return std::nullopt;
    const auto after = std::ranges::lower_bound(poses_, time, {}, &Entry::time);
    if (after == poses_.end())
        return poses_.back().pose;
    if (after == poses_.begin())
        return after->pose;
    const auto before = std::prev(after);
    const double part = (time - before->time) / (after->time - before->time);
    const Pose& a = before->pose;
    const Pose& b = after->pose;
    return Pose{a.position_m + part * (b.position_m - a.position_m), between(a.roll_rad, b.roll_rad, part),
                between(a.pitch_rad, b.pitch_rad, part), between(a.yaw_rad, b.yaw_rad, part)};
}

const PoseHistory::Entry* PoseHistory::earlier() const {
    if (poses_.size() < 2)
        return nullptr;
    const Seconds wanted = poses_.back().time - Seconds(0.45);
    const auto found = std::ranges::lower_bound(poses_, wanted, {}, &Entry::time);
    return &*std::min(found, std::prev(poses_.end(), 2));
}

Vec3 PoseHistory::velocity_m_s() const {
    const Entry* from = earlier();
    if (!from)
        return Vec3::Zero();
    return (poses_.back().pose.position_m - from->pose.position_m) / (poses_.back().time - from->time).count();
}

double PoseHistory::yawRate_rad_s() const {
    const Entry* from = earlier();
    if (!from)
        return 0.0;
    return normalizedAngle(poses_.back().pose.yaw_rad - from->pose.yaw_rad) / (poses_.back().time - from->time).count();
}

void CourseFilter::update(Seconds now, const Pose& ins_in_map, const std::optional<Vec2>& commanded_in_base_m_s) {
    const Seconds step = last_at_ && now >= *last_at_ ? now - *last_at_ : longest_interval;
    if (step < shortest_interval)
        return;
    last_at_ = now;
    const bool steady = commanded_in_base_m_s && (*commanded_in_base_m_s - command_m_s_).norm() < steady_m_s;
    steady_ticks_ = steady ? steady_ticks_ + 1 : 0;
    if (!steady)
        command_m_s_ = commanded_in_base_m_s.value_or(Vec2::Zero());
    if (last_) {
        const double turn_rad = normalizedAngle(ins_in_map.yaw_rad - last_->yaw_rad);
        predict(step, turn_rad);
        if (std::abs(turn_rad) < straight_rad && steady_ticks_ >= steady_ticks_needed && step < longest_interval)
            learn((ins_in_map.position_m - last_->position_m) / step.count(), last_->yaw_rad + turn_rad / 2.0,
                  *commanded_in_base_m_s);
    }
    last_ = ins_in_map;
}

void CourseFilter::predict(Seconds step, double turn_rad) {
    const double windy_m_s = std::max(0.0, wind_m_s().norm() - calm_m_s);
    const double gusts_m_s = calm_change_m_s + gust_share * windy_m_s;
    const double turned_m_s = turn_share * windy_m_s;
    covariance_(0, 0) += turn_variance_rad * std::abs(turn_rad);
    const double wind_variance =
        gusts_m_s * gusts_m_s * step.count() + turned_m_s * turned_m_s * std::abs(turn_rad) / (pi / 2.0);
    covariance_(1, 1) = std::min(covariance_(1, 1) + wind_variance, any_wind_m_s * any_wind_m_s);
    covariance_(2, 2) = std::min(covariance_(2, 2) + wind_variance, any_wind_m_s * any_wind_m_s);
}

void CourseFilter::learn(const Vec3& velocity_m_s, double heading_rad, const Vec2& commanded_in_base_m_s) {
    const Vec2 flown_m_s = Eigen::Rotation2Dd(heading_rad + correction_rad()) * commanded_in_base_m_s;
    Eigen::Matrix<double, 2, 3> slope; // It tells how the velocity changes with the state.
    slope << -flown_m_s.y(), 1.0, 0.0, flown_m_s.x(), 0.0, 1.0;
    const Vec2 error_m_s = velocity_m_s.head<2>() - flown_m_s - wind_m_s();
    const double noise = course_variance * velocity_m_s.squaredNorm() + rounding_m_s * rounding_m_s;
    const Eigen::Matrix2d spread = slope * covariance_ * slope.transpose() + noise * Eigen::Matrix2d::Identity();
    const Eigen::Matrix2d weight = spread.inverse();
    if (error_m_s.dot(weight * error_m_s) > outlier_sigmas2) {
        if (++surprises_ >= surprising_steps)
            doubtWind();
        return;
    }
    surprises_ = 0;
    const Eigen::Matrix<double, 3, 2> gain = covariance_ * slope.transpose() * weight;
    state_ += gain * error_m_s;
    state_[0] = std::clamp(state_[0], -limit_rad, limit_rad);
    const Eigen::Matrix3d kept = Eigen::Matrix3d::Identity() - gain * slope;
    covariance_ = kept * covariance_ * kept.transpose() + noise * gain * gain.transpose();
}

void CourseFilter::doubtWind() {
    surprises_ = 0;
    const double heading_variance_rad2 = covariance_(0, 0);
    const double any = any_wind_m_s * any_wind_m_s;
    covariance_ = Vec3(heading_variance_rad2, any, any).asDiagonal();
}

void CourseFilter::insWasSet() {
    const Vec2 wind = wind_m_s();
    const Vec2 variance = covariance_.diagonal().tail<2>().array() + next_flight_m_s * next_flight_m_s;
    *this = {};
    state_.tail<2>() = wind;
    covariance_.diagonal().tail<2>() = variance.cwiseMin(any_wind_m_s * any_wind_m_s);
}

} // namespace usar::airrobot
