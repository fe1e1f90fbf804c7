// Bodies as physics sees them: rigid parts, and links connected by joints. A body without links is one rigid body.
#pragma once

#include <variant>
#include <vector>

#include "core/base/geometry.h"

namespace usar::sim {

/// A cylinder along the z axis of its part's frame, centered on the origin.
struct CylinderShape {
    double radius_m = 0.0;
    double height_m = 0.0;
    bool operator==(const CylinderShape&) const = default;
};
/// A capsule along the z axis. `height_m` excludes the half-spheres at its ends.
struct CapsuleShape {
    double radius_m = 0.0;
    double height_m = 0.0;
    bool operator==(const CapsuleShape&) const = default;
};
/// `size_m` is the full extent along each axis.
struct BoxShape {
    Vec3 size_m = Vec3::Zero();
    bool operator==(const BoxShape&) const = default;
};
/// Centered on the origin of its part's frame.
struct SphereShape {
    double radius_m = 0.0;
    bool operator==(const SphereShape&) const = default;
};

/// A convex solid.
/// Other solids, such as concave ones, are put together from several parts.
using Shape = std::variant<CylinderShape, CapsuleShape, BoxShape, SphereShape>;

/// One convex part of a body.
struct BodyPart {
    Shape shape;
    Pose part_in_body;
    bool operator==(const BodyPart&) const = default;
};

/// One rigid body. The origin of its frame is its center of mass. Without parts it touches nothing.
struct BodyDescription {
    double mass_kg = 1.0;              ///< above 0; ignored if `still`
    Vec3 inertia_kg_m2 = Vec3::Ones(); ///< moments about the axes of the body's frame
    double friction = 0.9;             ///< coefficient, multiplied with that of the other side; 1 for the ground
    /// Parts may overlap; they do not collide with one another.
    std::vector<BodyPart> parts{};
    double restitution = 0.0;        ///< share of the closing speed that a bounce gives back, 0 to 1
    double rolling_friction_m = 0.0; ///< rolling resistance torque divided by normal force
    bool still = false;              ///< stays where it is placed, whatever pushes it
    double rest_rad_s = 0.02;        ///< a rigid body that turns more slowly may count as at rest (Physics::letSleep)
    bool operator==(const BodyDescription&) const = default;
};

/// Revolute joints turn about their axis; prismatic ones slide along it.
enum class JointKind { Revolute, Prismatic };

/// A rigid body connected to an earlier one by a joint with one degree of freedom.
struct LinkDescription {
    BodyDescription body;
    int parent = -1;     ///< index of an earlier link, or -1: the base
    Pose link_in_parent; ///< while the joint is at 0; both frames have their origins in the centers of mass
    Vec3 pivot_in_link_m = Vec3::Zero(); ///< a point on the joint's axis
    Vec3 axis_in_link = Vec3::UnitZ();   ///< unit vector; positive turns are right-handed about it
    JointKind kind = JointKind::Revolute;
    double lower = 1.0; ///< rad or m; above `upper` if there are no limits
    double upper = -1.0;
    double damping = 0.0; ///< N m s/rad or N s/m
};

/// A base and the links that hang on it, directly or one on another.
struct ArticulatedDescription {
    BodyDescription base;
    /// Each one comes after its parent.
    std::vector<LinkDescription> links{};
};

/// Position and velocity of a joint: rad and rad/s, or m and m/s.
struct JointState {
    double position = 0.0;
    double velocity = 0.0;
};

/// Command to a joint, in force until the next one. It acts with no more than `limit` (N m or N).
struct JointMotor {
    /// Position moves there and holds; Velocity holds a speed; Torque pushes.
    /// Off leaves the joint to its damping.
    enum class Mode { Off, Position, Velocity, Torque };
    Mode mode = Mode::Off;
    double target = 0.0;        ///< rad, rad/s or N m (m, m/s, N)
    double limit = 0.0;         ///< largest torque or force
    double largest_speed = 1e9; ///< speed at which Position approaches its target and which Torque can reach
    bool operator==(const JointMotor&) const = default;
};

} // namespace usar::sim
