// A body of several links on joints, as physics sees it. A body without links is one rigid body.
#pragma once

#include <variant>
#include <vector>

#include "core/base/geometry.h"

namespace usar::sim {

/// Upright in its part's frame: axis along z.
struct CylinderShape {
    double radius_m = 0.0;
    double height_m = 0.0;
    bool operator==(const CylinderShape&) const = default;
};
/// `height_m` is without the two half-spheres at its ends.
struct CapsuleShape {
    double radius_m = 0.0;
    double height_m = 0.0;
    bool operator==(const CapsuleShape&) const = default;
};
struct BoxShape {
    Vec3 size_m = Vec3::Zero();
    bool operator==(const BoxShape&) const = default;
};
struct SphereShape {
    double radius_m = 0.0;
    bool operator==(const SphereShape&) const = default;
};

/// One convex part of a body.
struct BodyPart {
    std::variant<CylinderShape, CapsuleShape, BoxShape, SphereShape> shape;
    Pose part_in_body;
    bool operator==(const BodyPart&) const = default;
};

/// What is rigid. The body frame's origin is its center of mass. Without parts it touches nothing.
struct BodyDescription {
    double mass_kg = 1.0;
    Vec3 inertia_kg_m2 = Vec3::Ones(); ///< about the body's axes
    double friction = 0.9;
    std::vector<BodyPart> parts{};
    double restitution = 0.0;
    double rolling_friction_m = 0.0; ///< rolling resistance torque over normal force
    bool still = false;              ///< stays where it is placed, whatever pushes it
    bool operator==(const BodyDescription&) const = default;
};

enum class JointKind { Revolute, Prismatic };

/// A rigid body that hangs on an earlier one by a joint with one degree of freedom.
struct LinkDescription {
    BodyDescription body;
    int parent = -1;     ///< an earlier link, or -1: the base
    Pose link_in_parent; ///< while the joint stands at 0; both frames have their origins in the centers of mass
    Vec3 pivot_in_link_m = Vec3::Zero();
    Vec3 axis_in_link = Vec3::UnitZ(); ///< unit; positive turns are right-handed about it
    JointKind kind = JointKind::Revolute;
    double lower = 1.0; ///< rad or m; above `upper` where there are no limits
    double upper = -1.0;
    double damping = 0.0; ///< N m s/rad or N s/m
};

struct ArticulatedDescription {
    BodyDescription base;
    std::vector<LinkDescription> links{};
};

/// rad and rad/s, or m and m/s.
struct JointState {
    double position = 0.0;
    double velocity = 0.0;
};

/// What drives a joint until it is told otherwise, with no more than `limit` (N m or N).
struct JointMotor {
    enum class Mode { Off, Position, Velocity, Torque };
    Mode mode = Mode::Off;
    double target = 0.0; ///< rad, rad/s or N m (m, m/s, N)
    double limit = 0.0;
    double largest_speed = 1e9; ///< how fast Position goes there and Torque can make it
    bool operator==(const JointMotor&) const = default;
};

} // namespace usar::sim
