// The AirRobot's own autopilot: turns velocity commands into a rotor wrench by a cascade of velocity, tilt and rate
// loops.
#pragma once

#include <array>

#include "core/base/clock.h"
#include "core/sim/physics/physics.h"
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
    /// True if a rotor does not give all of its thrust.
    bool weak() const { return strengths_ != full_strength; }
    /// Lets the thrusts follow what was commanded.
    void step(Seconds dt);
    /// The wrench that the rotors exert now.
    RotorWrench wrench() const;

private:
    static constexpr std::array<double, 4> full_strength{1.0, 1.0, 1.0, 1.0};

    AirRobotParameters parameters_;
    std::array<Vec3, 4> centers_m_;
    std::array<double, 4> commanded_n_{};
    std::array<double, 4> thrusts_n_{};
    std::array<double, 4> strengths_ = full_strength; ///< see weaken()
};

/// A velocity command in the robot's level frame (yaw only), within the robot's limits.
struct VelocityCommand {
    double forward_m_s = 0.0;
    double left_m_s = 0.0;
    double climb_m_s = 0.0;
    double yaw_rate_rad_s = 0.0;
    bool operator==(const VelocityCommand&) const = default;
};

/// A reference model with limited acceleration and jerk leads; hover thrust and drag are fed forward. Velocity errors
/// are integrated, so that height and place are held and not only their rates. Tilt and its rate are limited. Runs once
/// per physics step. Owned by its robot.
class FlightController {
public:
    explicit FlightController(const AirRobotParameters& parameters);

    /// Forgets references and integrals; the next wrench starts from this attitude.
    void reset(const BodyState& state);
    /// The wrench for the next physics step of length `dt`.
    RotorWrench control(const BodyState& state, const VelocityCommand& command, Seconds dt);
    /// For a robot on the ground: carries a share of its weight and damps turning, but holds no attitude, so that the
    /// body adapts to the slope.
    RotorWrench settle(const BodyState& state, double weight_share) const;

private:
    void lead(const VelocityCommand& command, double dt_s);
    /// Turns vectors between the map frame and a level frame that has the robot's yaw.
    struct Heading {
        double cos_yaw = 1.0;
        double sin_yaw = 0.0;
        Vec3 turned(const Vec3& level) const {
            return {cos_yaw * level.x() - sin_yaw * level.y(), sin_yaw * level.x() + cos_yaw * level.y(), level.z()};
        }
        Vec3 leveled(const Vec3& in_map) const { return Heading{cos_yaw, -sin_yaw}.turned(in_map); }
    };

    Vec3 wantedAcceleration(const BodyState& state, const Heading& heading, double dt_s);
    /// `level_m_s2`: wanted acceleration in the level frame.
    void tiltToward(const Vec3& level_m_s2, double dt_s);
    Vec3 torque(const BodyState& state) const;

    AirRobotParameters parameters_;
    Vec3 reference_m_s_ = Vec3::Zero();  ///< level frame
    Vec3 reference_m_s2_ = Vec3::Zero(); ///< level frame
    Vec3 lagged_m_s_ = Vec3::Zero();     ///< the reference, as far as the tilt loop can follow it
    Vec3 lag_m_ = Vec3::Zero();          ///< integrated velocity error, map frame
    Vec2 tilt_rad_ = Vec2::Zero();       ///< wanted roll and pitch
    Vec2 tilt_rate_rad_s_ = Vec2::Zero();
    double yaw_rad_ = 0.0; ///< wanted yaw
    double yaw_rate_rad_s2_ = 0.0;
    double yaw_rate_rad_s_ = 0.0; ///< wanted yaw rate
};

} // namespace usar::sim
