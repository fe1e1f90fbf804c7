// The AirRobot's own autopilot: velocity commands to a rotor wrench, by a cascade of velocity, tilt and rate loops.
#pragma once

#include "core/base/clock.h"
#include "core/sim/physics.h"
#include "core/sim/robots/air_robot_parameters.h"
#include "core/sim/robots/rotors.h"

namespace usar::sim {

/// What the robot was told to do, in its level frame (yaw only); within the robot's limits.
struct VelocityCommand {
    double forward_m_s = 0.0;
    double left_m_s = 0.0;
    double climb_m_s = 0.0;
    double yaw_rate_rad_s = 0.0;
    bool operator==(const VelocityCommand&) const = default;
};

/// A reference model limited in acceleration and jerk leads; hover thrust and drag are fed forward; velocity errors are
/// integrated, so that height and place are held and not only their rates. Tilt and its rate are limited.
/// Runs once a physics step. Owned by its robot.
class FlightController {
public:
    explicit FlightController(const AirRobotParameters& parameters);

    /// Forgets references and integrals; the next wrench starts from this attitude.
    void reset(const BodyState& state);
    RotorWrench control(const BodyState& state, const VelocityCommand& command, Seconds dt);
    /// On the ground: a share of the weight carried, turning damped, no attitude held: the body finds the slope.
    RotorWrench settle(const BodyState& state, double weight_share) const;

private:
    void lead(const VelocityCommand& command, double dt_s);
    Vec3 wantedAcceleration(const BodyState& state, double dt_s);
    void tiltToward(const Vec3& acceleration_m_s2, double yaw_rad, double dt_s);
    Vec3 torque(const BodyState& state) const;

    AirRobotParameters parameters_;
    Vec3 reference_m_s_ = Vec3::Zero();  ///< level frame
    Vec3 reference_m_s2_ = Vec3::Zero(); ///< level frame
    Vec3 lagged_m_s_ = Vec3::Zero();     ///< the reference as the tilt loop can follow it
    Vec3 lag_m_ = Vec3::Zero();          ///< integrated velocity error, map frame
    Vec2 tilt_rad_ = Vec2::Zero();       ///< wanted roll and pitch
    Vec2 tilt_rate_rad_s_ = Vec2::Zero();
    double yaw_rad_ = 0.0; ///< wanted
    double yaw_rate_rad_s2_ = 0.0;
    double yaw_rate_rad_s_ = 0.0; ///< wanted
};

} // namespace usar::sim
