#include "core/sim/robots/rotors.h"

#include <algorithm>
#include <cmath>

namespace usar::sim {

namespace {

// Front left and rear right turn one way, the other two the other way; +1 turns the body counter-clockwise.
constexpr std::array<double, 4> yaw_sense{-1.0, 1.0, -1.0, 1.0};

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

} // namespace usar::sim
