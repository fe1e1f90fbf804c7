#include "robots/airrobot/flight/pose_estimate.h"

#include <algorithm>
#include <cmath>

namespace usar::airrobot {

namespace {

/// Growth of the variance per radian of turn, which is (1.1 degrees)^2 per right angle.
constexpr double turn_variance_rad = 2.4e-4;
/// Variance of the course of one step: 5 % of the step sideways, plus what the autopilot does not correct.
constexpr double course_variance_rad2 = 0.0036;
constexpr double steady_m_s = 0.12;
constexpr Seconds shortest_interval{0.15};
constexpr int steady_ticks_needed = 6;
constexpr double slowest_m_s = 0.5;
constexpr double straight_rad = 0.02;
constexpr double shortest_step_m = 0.05;
/// A larger error is not drift; something is holding the robot.
constexpr double outlier_rad = 0.5;
constexpr double limit_rad = 0.4;

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

void CourseFilter::update(Seconds now, const Pose& ins_in_map, const Vec2& commanded_in_base_m_s) {
    if (last_at_ && now >= *last_at_ && now - *last_at_ < shortest_interval)
        return;
    last_at_ = now;
    const bool steady = (commanded_in_base_m_s - command_m_s_).norm() < steady_m_s;
    steady_ticks_ = steady ? steady_ticks_ + 1 : 0;
    if (!steady)
        command_m_s_ = commanded_in_base_m_s;
    if (last_) {
        const double turn_rad = normalizedAngle(ins_in_map.yaw_rad - last_->yaw_rad);
        variance_rad2_ += turn_variance_rad * std::abs(turn_rad);
        const bool straight = std::abs(turn_rad) < straight_rad && commanded_in_base_m_s.norm() > slowest_m_s;
        const Vec2 step_m = (ins_in_map.position_m - last_->position_m).head<2>();
        if (straight && steady_ticks_ >= steady_ticks_needed && step_m.norm() > shortest_step_m)
            learn(step_m,
                  last_->yaw_rad + turn_rad / 2.0 + std::atan2(commanded_in_base_m_s.y(), commanded_in_base_m_s.x()));
    }
    last_ = ins_in_map;
}

void CourseFilter::learn(const Vec2& step_m, double expected_rad) {
    const double course_rad = bearingOf(step_m);
    const double error_rad = normalizedAngle(course_rad - expected_rad - correction_rad_);
    if (std::abs(error_rad) > outlier_rad)
        return;
    const double gain = variance_rad2_ / (variance_rad2_ + course_variance_rad2);
    correction_rad_ = std::clamp(correction_rad_ + gain * error_rad, -limit_rad, limit_rad);
    variance_rad2_ *= 1.0 - gain;
}

} // namespace usar::airrobot
