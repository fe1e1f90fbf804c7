// The AirRobot's figures from robots-and-worlds.md 3.1, with the assumptions made there. SI units, body frame.
#pragma once

#include <array>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/sim/physics/physics.h"
#include "core/sim/robots/robot_model.h"

namespace usar::sim {

/// The defaults are the AirRobot's; a robot file can replace some of them.
struct AirRobotParameters {
    double mass_kg = 1.0;
    Vec3 inertia_kg_m2{0.041, 0.041, 0.080};

    // Four rotors in an X configuration; thrust acts along the body's z axis.
    double rotor_span_m = 0.19; ///< |x| and |y| of each rotor's center
    double rotor_radius_m = 0.17;
    double rotor_limit_n = 6.0;
    Seconds rotor_lag{0.05};
    double rotor_drag_m = 0.03; ///< yaw torque divided by thrust

    double drag_kg_m = 0.2; ///< force = drag * speed^2: a dead robot falls at no more than 7 m/s
    double spin_drag_n_m_s = 0.02;

    double forward_limit_m_s = 2.0;
    double sideways_limit_m_s = 2.0;
    double climb_limit_m_s = 2.0;
    double yaw_rate_limit_rad_s = 1.745;
    double tilt_limit_rad = radians(25.0);
    double tilt_rate_limit_rad_s = 0.67;

    // A ring guard with the rotor discs inside, a belly pod, and four legs that keep the discs 0.2 m above the ground.
    double ring_radius_m = 0.4995;
    double ring_height_m = 0.05;
    Vec3 pod_size_m{0.20, 0.20, 0.09};
    double leg_span_m = 0.25; ///< |x| and |y| of each leg
    double leg_radius_m = 0.02;
    double leg_tip_z_m = -0.21; ///< lowest point of the legs

    double breaking_impulse_n_s = 0.5; ///< contacts of one step with more than this break it
    double safe_touchdown_m_s = 1.0;   ///< touching down this fast or faster breaks it
};

/// The default parameters, overridden by the mass, inertia and figures that the model's drive gives: settings by the
/// names of the parameters, without units: forward_limit, thrust_limit, tilt_limit …
AirRobotParameters airRobotParametersOf(const RobotModel& model);

/// Centers of the rotors in this order: front left, front right, rear right, rear left.
std::array<Vec3, 4> rotorCenters(const AirRobotParameters& parameters);
/// The rigid body with ring, pod and legs as its parts.
BodyDescription bodyOf(const AirRobotParameters& parameters);

/// Gear is the legs; Guard the ring outside of the discs; Belly the pod.
enum class AirRobotPart { Gear, Guard, RotorDisc, Belly };
/// The part of the hull that a point on it belongs to.
AirRobotPart partAt(const AirRobotParameters& parameters, const Vec3& point_in_body_m);

} // namespace usar::sim
