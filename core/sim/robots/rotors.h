// Four rotors with a thrust limit and a first-order lag, and the mixer that turns a wrench into thrusts.
#pragma once

#include <array>

#include "core/base/clock.h"
#include "core/sim/robots/air_robot_parameters.h"

namespace usar::sim {

/// Thrust along the body's z axis and torque about its center of mass, in the body frame.
struct RotorWrench {
    double thrust_n = 0.0;
    Vec3 torque_n_m = Vec3::Zero();
};

/// Rotors 0..3 are in the order of `rotorCenters`.
class Rotors {
public:
    explicit Rotors(const AirRobotParameters& parameters);

    /// Sets the thrusts that give `wanted`, each clamped to 0..limit; the rotors follow with their lag.
    void command(const RotorWrench& wanted);
    /// Lets the rotors run down.
    void stop();
    /// Makes the rotors turn already, with this thrust in all.
    void start(double thrust_n);
    /// Makes rotor 0..3 give only this share of its thrust; the mixer does not know about it.
    void weaken(std::size_t rotor, double share) { strengths_[rotor] = share; }
    /// Lets the thrusts follow what was commanded.
    void step(Seconds dt);
    /// The wrench that the rotors exert now.
    RotorWrench wrench() const;
    /// The thrusts that the rotors give now.
    const std::array<double, 4>& thrusts_n() const { return thrusts_n_; }

private:
    AirRobotParameters parameters_;
    std::array<Vec3, 4> centers_m_;
    std::array<double, 4> commanded_n_{};
    std::array<double, 4> thrusts_n_{};
    std::array<double, 4> strengths_{1.0, 1.0, 1.0, 1.0}; ///< see weaken()
};

} // namespace usar::sim
