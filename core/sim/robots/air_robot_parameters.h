// The AirRobot's figures from robots-and-worlds.md 3.1, with the assumptions made there. SI units, body frame.
#pragma once

#include <array>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/sim/robots/robot_model.h"

namespace usar::sim {

/// The usual values are the AirRobot's. The drive of a robot file can replace those that have a name here.
struct AirRobotParameters {
    Numbers numbers{}; ///< figures that replace the usual ones, by name
    double mass_kg = 1.0;
    Vec3 inertia_kg_m2{0.041, 0.041, 0.080};

    // Four rotors in an X configuration; thrust acts along the body's z axis.
    double rotor_span_m = numberOr(numbers, "rotor_span", 0.19); ///< |x| and |y| of each rotor's center
    double rotor_radius_m = numberOr(numbers, "rotor_radius", 0.17);
    double rotor_limit_n = numberOr(numbers, "thrust_limit", 6.0);
    Seconds rotor_lag{numberOr(numbers, "rotor_lag", 0.05)};
    double rotor_drag_m = numberOr(numbers, "rotor_drag", 0.03); ///< yaw torque divided by thrust

    /// Force = drag * speed^2: a dead robot falls at no more than 7 m/s.
    double drag_kg_m = numberOr(numbers, "drag", 0.2);
    double spin_drag_n_m_s = numberOr(numbers, "spin_drag", 0.02);

    double forward_limit_m_s = numberOr(numbers, "forward_limit", 2.0);
    double sideways_limit_m_s = numberOr(numbers, "sideways_limit", 2.0);
    double climb_limit_m_s = numberOr(numbers, "climb_limit", 2.0);
    double yaw_rate_limit_rad_s = numberOr(numbers, "yaw_rate_limit", 1.745);
    double tilt_limit_rad = numberOr(numbers, "tilt_limit", radians(25.0));
    double tilt_rate_limit_rad_s = numberOr(numbers, "tilt_rate_limit", 0.67);

    // The rotor discs are inside a ring guard; below them hang a belly pod and four legs.
    double ring_radius_m = numberOr(numbers, "ring_radius", 0.4995);
    double ring_height_m = numberOr(numbers, "ring_height", 0.05);
    double pod_width_m = numberOr(numbers, "pod_width", 0.20);

    /// Contacts of one step with more than this break it.
    double breaking_impulse_n_s = numberOr(numbers, "breaking_impulse", 0.5);
    /// Touching down this fast or faster breaks it.
    double safe_touchdown_m_s = numberOr(numbers, "safe_touchdown", 1.0);
};

/// Centers of the rotors in this order: front left, front right, rear right, rear left.
std::array<Vec3, 4> rotorCenters(const AirRobotParameters& parameters);

/// A box, in the body frame.
struct BodyBox {
    Vec3 center_m = Vec3::Zero();
    double yaw_rad = 0.0;
    Vec3 size_m = Vec3::Zero();
};
/// Boxes that cover the ring outside of the discs, from its middle to where its upper edge (`above`) or its lower one
/// would be if it had gone on until the plane of the rotors is where that edge is now.
std::array<BodyBox, 24> ringAsFarAsRotors(const AirRobotParameters& parameters, bool above);

/// Gear is the legs; Guard the ring outside of the discs; Belly the pod.
enum class AirRobotPart { Gear, Guard, RotorDisc, Belly };
/// The part of the hull that a point on it belongs to.
AirRobotPart partAt(const AirRobotParameters& parameters, const Vec3& point_in_body_m);

} // namespace usar::sim
