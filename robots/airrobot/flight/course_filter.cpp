#include "robots/airrobot/flight/course_filter.h"

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

} // namespace

void CourseFilter::reset() {
    last_at_.reset();
    last_.reset();
    command_m_s_ = Vec2::Zero();
    steady_ticks_ = 0;
    correction_rad_ = variance_rad2_ = 0.0;
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
