#include "core/sim/robots/flight_controller.h"

#include <algorithm>
#include <cmath>

namespace usar::sim {

namespace {

// Front left and rear right turn one way, the other two the other way; +1 turns the body counter-clockwise.
constexpr std::array<double, 4> yaw_sense{-1.0, 1.0, -1.0, 1.0};

// Reference model: critically damped; 1 m/s settles in about 1.5 s.
constexpr double lead_rad_s = 4.5;
const Vec3 acceleration_limit_m_s2(2.5, 2.5, 3.0);
const Vec3 jerk_limit_m_s3(6.0, 6.0, 20.0);
// Time by which the body lags the reference: tilt loop and rotors sideways, rotors alone upward.
const Vec3 tracking_lag_s(0.12, 0.12, 0.06);
const Vec3 velocity_gain_per_s(2.0, 2.0, 4.0);
const Vec3 place_gain_per_s2(1.0, 1.0, 4.0);
constexpr double lag_limit_m = 0.5;
// Gains of the tilt and rate loops.
constexpr double tilt_gain_per_s2 = 64.0;
constexpr double rate_gain_per_s = 13.0;
// While the rotors lag, the body overshoots the rate of its reference by a quarter.
constexpr double tilt_rate_share = 0.78;
constexpr double yaw_gain_per_s2 = 4.0;
constexpr double yaw_rate_gain_per_s = 6.0;
constexpr double yaw_acceleration_limit_rad_s2 = 3.0;
constexpr double yaw_lag_limit_rad = 0.3;
constexpr double settling_rate_gain_per_s = 40.0;
constexpr double least_weight_share = 0.3;
constexpr double most_weight_share = 1.9;

Eigen::Quaterniond rotationOf(const Vec2& tilt_rad, double yaw_rad) {
    return Pose{Vec3::Zero(), tilt_rad.x(), tilt_rad.y(), yaw_rad}.rotation();
}

/// Returns the yaw as Pose::from does, without the two other angles, which nobody asks for in each step.
double yawOf(const Eigen::Quaterniond& rotation) {
    const Eigen::Matrix3d r = rotation.normalized().toRotationMatrix();
    return std::atan2(r(1, 0), r(0, 0));
}

Vec3 clamped(const Vec3& value, const Vec3& limit) {
    return value.cwiseMax(-limit).cwiseMin(limit);
}

} // namespace

Rotors::Rotors(const AirRobotParameters& parameters) : parameters_(parameters), centers_m_(rotorCenters(parameters)) {}

void Rotors::command(const RotorWrench& wanted) {
    const double arm_m = parameters_.rotor_span_m;
    for (std::size_t i = 0; i < 4; ++i) {
        const double roll = wanted.torque_n_m.x() * centers_m_[i].y() / (4.0 * arm_m * arm_m);
        const double pitch = -wanted.torque_n_m.y() * centers_m_[i].x() / (4.0 * arm_m * arm_m);
        const double yaw = wanted.torque_n_m.z() * yaw_sense[i] / (4.0 * parameters_.rotor_drag_m);
        commanded_n_[i] = std::clamp(wanted.thrust_n / 4.0 + roll + pitch + yaw, 0.0, parameters_.rotor_limit_n);
    }
}

void Rotors::stop() {
    commanded_n_ = {};
}

void Rotors::start(double thrust_n) {
    commanded_n_.fill(thrust_n / 4.0);
    thrusts_n_ = commanded_n_;
}

void Rotors::step(Seconds dt) {
    const double share = 1.0 - std::exp(-dt / parameters_.rotor_lag);
    for (std::size_t i = 0; i < 4; ++i)
        thrusts_n_[i] += share * (strengths_[i] * commanded_n_[i] - thrusts_n_[i]);
}

RotorWrench Rotors::wrench() const {
    RotorWrench sum;
    for (std::size_t i = 0; i < 4; ++i) {
        sum.thrust_n += thrusts_n_[i];
        sum.torque_n_m += Vec3(centers_m_[i].y() * thrusts_n_[i], -centers_m_[i].x() * thrusts_n_[i],
                               yaw_sense[i] * parameters_.rotor_drag_m * thrusts_n_[i]);
    }
    return sum;
}

FlightController::FlightController(const AirRobotParameters& parameters) : parameters_(parameters) {}

void FlightController::reset(const BodyState& state) {
    const Pose pose = state.pose();
    reference_m_s_ = reference_m_s2_ = lagged_m_s_ = lag_m_ = Vec3::Zero();
    tilt_rad_ = {pose.roll_rad, pose.pitch_rad};
    tilt_rate_rad_s_ = Vec2::Zero();
    yaw_rad_ = pose.yaw_rad;
    yaw_rate_rad_s_ = yaw_rate_rad_s2_ = 0.0;
}

RotorWrench FlightController::control(const BodyState& state, const VelocityCommand& command, Seconds dt) {
    const double yaw_rad = yawOf(state.rotation);
    const Heading heading{std::cos(yaw_rad), std::sin(yaw_rad)};
    lead(command, dt.count());
    yaw_rad_ = yaw_rad + std::clamp(normalizedAngle(yaw_rad_ - yaw_rad), -yaw_lag_limit_rad, yaw_lag_limit_rad);
    const Vec3 wanted_m_s2 = wantedAcceleration(state, heading, dt.count());
    tiltToward(heading.leveled(wanted_m_s2), dt.count());
    const double weight_n = parameters_.mass_kg * gravity_m_s2;
    const double upright = std::max(0.5, (state.rotation * Vec3::UnitZ()).z());
    const double lift_n = parameters_.mass_kg * (gravity_m_s2 + wanted_m_s2.z()) / upright;
    return {std::clamp(lift_n, least_weight_share * weight_n, most_weight_share * weight_n), torque(state)};
}

RotorWrench FlightController::settle(const BodyState& state, double weight_share) const {
    const Vec3 rate_rad_s = state.rotation.conjugate() * state.rate_rad_s;
    return {weight_share * parameters_.mass_kg * gravity_m_s2,
            -settling_rate_gain_per_s * parameters_.inertia_kg_m2.cwiseProduct(rate_rad_s)};
}

void FlightController::lead(const VelocityCommand& command, double dt_s) {
    const Vec3 commanded_m_s(command.forward_m_s, command.left_m_s, command.climb_m_s);
    const Vec3 wanted_m_s2 = clamped(lead_rad_s / 2.0 * (commanded_m_s - reference_m_s_), acceleration_limit_m_s2);
    const Vec3 jerk_m_s3 = clamped(2.0 * lead_rad_s * (wanted_m_s2 - reference_m_s2_), jerk_limit_m_s3);
    reference_m_s2_ += jerk_m_s3 * dt_s;
    reference_m_s_ += reference_m_s2_ * dt_s;
    lagged_m_s_ += (reference_m_s_ - lagged_m_s_).cwiseQuotient(tracking_lag_s) * dt_s;

    const double step_rad_s = yaw_acceleration_limit_rad_s2 * dt_s;
    const double change_rad_s = std::clamp(command.yaw_rate_rad_s - yaw_rate_rad_s_, -step_rad_s, step_rad_s);
    yaw_rate_rad_s_ += change_rad_s;
    yaw_rate_rad_s2_ = change_rad_s / dt_s;
    yaw_rad_ += yaw_rate_rad_s_ * dt_s;
}

Vec3 FlightController::wantedAcceleration(const BodyState& state, const Heading& heading, double dt_s) {
    const Vec3 error_m_s = heading.turned(lagged_m_s_) - state.velocity_m_s;
    lag_m_ = clamped(lag_m_ + error_m_s * dt_s, Vec3::Constant(lag_limit_m));
    const Vec3 drag_m_s2 = parameters_.drag_kg_m / parameters_.mass_kg * state.velocity_m_s.norm() * state.velocity_m_s;
    const Vec3 turning_m_s2(-yaw_rate_rad_s_ * lagged_m_s_.y(), yaw_rate_rad_s_ * lagged_m_s_.x(), 0.0);
    return heading.turned(reference_m_s2_ + turning_m_s2) + velocity_gain_per_s.cwiseProduct(error_m_s) +
           place_gain_per_s2.cwiseProduct(lag_m_) + drag_m_s2;
}

void FlightController::tiltToward(const Vec3& level_m_s2, double dt_s) {
    const double lift_m_s2 = std::max(0.5 * gravity_m_s2, gravity_m_s2 + level_m_s2.z());
    Vec2 wanted_rad(-std::atan2(level_m_s2.y(), lift_m_s2), std::atan2(level_m_s2.x(), lift_m_s2));
    if (wanted_rad.norm() > parameters_.tilt_limit_rad)
        wanted_rad *= parameters_.tilt_limit_rad / wanted_rad.norm();
    Vec2 change_rad = wanted_rad - tilt_rad_;
    const double limit_rad = tilt_rate_share * parameters_.tilt_rate_limit_rad_s * dt_s;
    if (change_rad.norm() > limit_rad)
        change_rad *= limit_rad / change_rad.norm();
    tilt_rad_ += change_rad;
    tilt_rate_rad_s_ = change_rad / dt_s;
}

Vec3 FlightController::torque(const BodyState& state) const {
    const Eigen::Quaterniond wanted = rotationOf(tilt_rad_, yaw_rad_);
    Eigen::Quaterniond error = state.rotation.conjugate() * wanted;
    if (error.w() < 0.0)
        error.coeffs() = -error.coeffs();
    const Vec3 rate_rad_s = state.rotation.conjugate() * state.rate_rad_s;
    const Vec3 wanted_rate_rad_s(tilt_rate_rad_s_.x(), tilt_rate_rad_s_.y(), yaw_rate_rad_s_);
    const Vec3 angle_gain(tilt_gain_per_s2, tilt_gain_per_s2, yaw_gain_per_s2);
    const Vec3 rate_gain(rate_gain_per_s, rate_gain_per_s, yaw_rate_gain_per_s);
    const Vec3 wanted_rad_s2 = 2.0 * angle_gain.cwiseProduct(error.vec()) +
                               rate_gain.cwiseProduct(wanted_rate_rad_s - rate_rad_s) +
                               Vec3(0.0, 0.0, yaw_rate_rad_s2_);
    return parameters_.inertia_kg_m2.cwiseProduct(wanted_rad_s2);
}

} // namespace usar::sim
