// Rigid bodies among a world's fixed parts: the interface that a physics engine implements. Map frame (z up), SI units.
// No engine header is visible here; see robots-and-worlds.md 6 for the choice of Bullet.
#pragma once

#include <memory>
#include <span>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/base/id.h"
#include "core/sim/world/articulation.h"
#include "core/sim/world/world.h"

namespace usar::sim {

/// Identifies a body of one Physics, from 1; never reused.
using BodyId = Id<struct BodyTag, 0U>;

/// State of a body or link at its center of mass, map frame.
struct BodyState {
    Vec3 position_m = Vec3::Zero();
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Vec3 velocity_m_s = Vec3::Zero();
    Vec3 rate_rad_s = Vec3::Zero(); ///< angular velocity, map frame
    Pose pose() const { return Pose::from(position_m, rotation); }
};

/// The kinds of things that a body can touch.
enum class Surface { Ground, Plant, Building, Body };

/// A point at which a body was pressed during the last step.
struct Contact {
    Surface surface = Surface::Ground;
    Vec3 point_in_body_m = Vec3::Zero(); ///< in the frame of the touched link
    double impulse_n_s = 0.0;            ///< along the normal
    double closing_speed_m_s = 0.0;      ///< before the step, positive when approaching
    int link = -1;                       ///< the touched link; -1: the base
    Vec3 normal_in_map = Vec3::UnitZ();  ///< unit vector out of the other thing, toward this body
};

/// Deterministic on one build: the same calls give the same bits. Single-threaded; owned by a Simulation. Every id that
/// is passed must be that of an existing body.
class Physics {
public:
    virtual ~Physics() = default;

    /// Adds a rigid body, at rest.
    virtual BodyId add(const BodyDescription& description, const Pose& body_in_map) = 0;
    /// Adds an articulated body in Featherstone's reduced coordinates, with all joints at 0 and without motors.
    /// `state`, `apply` and `place` without a link mean the base. Links of one body do not touch each other.
    virtual BodyId add(const ArticulatedDescription& description, const Pose& base_in_map) = 0;
    virtual void remove(BodyId body) = 0;
    /// Moves a body to a pose, at rest; its joints stay where they are.
    virtual void place(BodyId body, const Pose& body_in_map) = 0;
    /// A body that may sleep is frozen after two seconds at rest until something moves it; otherwise contacts let it
    /// creep by millimeters a minute. Forces on a sleeping body have no effect, so one that pushes must not sleep.
    virtual void letSleep(BodyId body, bool allowed) = 0;
    /// True while the body is frozen where it is.
    virtual bool isAsleep(BodyId body) const = 0;
    /// True while the body is inside fixed parts of the world or another body, or under the ground.
    virtual bool isStuck(BodyId body) = 0;

    /// State of a rigid body, or of the base of an articulated one.
    virtual BodyState state(BodyId body) const = 0;
    virtual BodyState state(BodyId body, std::size_t link) const = 0;
    /// State of the joint that a link hangs on; a rigid body has none and returns zeros.
    virtual JointState joint(BodyId body, std::size_t link) const = 0;
    /// Drives a joint until the next call; a rigid body ignores it.
    virtual void setMotor(BodyId body, std::size_t link, const JointMotor& motor) = 0;
    /// Makes the surface of a still body move: what lies on it is carried along, as on a belt and as far as friction
    /// can; the body itself stays.
    virtual void runSurface(BodyId body, const Vec3& velocity_in_body_m_s) = 0;
    /// Applies force and torque at the center of mass during the next step only; several calls add up. A sleeping body
    /// is not pushed: where the force may move it, it must not be allowed to sleep.
    virtual void apply(BodyId body, const Vec3& force_in_map_n, const Vec3& torque_in_map_n_m) = 0;
    /// Simulates one fixed step under gravity (9.81 m/s2).
    virtual void step(Seconds dt) = 0;
    /// Contacts of the body and all its links during the last step; valid until the next step.
    virtual std::span<const Contact> contacts(BodyId body) const = 0;

    /// Distance to the first body other than `except` that a ray meets, or `nearest_m` if none is closer. The fixed
    /// world is not considered. `direction` is a unit vector. `nearest_m` must not exceed `maximum_m`, the length of
    /// the segment that the engine tests; the last digits of the result depend on it.
    virtual double castAtBodies(const Vec3& origin_m, const Vec3& direction, double maximum_m, double nearest_m,
                                BodyId except) const = 0;
    /// True if a body other than `except` may reach into the box; if false, there is none.
    virtual bool hasBodies(const Eigen::AlignedBox3d& box_in_map_m, BodyId except) const = 0;
    /// True if the fixed world or a body other than `except` reaches into the box around `center_in_map_m`.
    virtual bool meetsBox(const Vec3& center_in_map_m, const Eigen::Quaterniond& rotation, const Vec3& size_m,
                          BodyId except) = 0;
    /// Distance from a point to the nearest body's origin, that of `except` left out; infinite if there is none.
    virtual double distanceToBodies_m(const Vec3& point_m, BodyId except) const = 0;
};

/// The engine's gravity, for those who must compensate it.
inline constexpr double gravity_m_s2 = 9.81;

/// Creates the implementation with Bullet in double precision. `world` must outlive it: its heights are not copied.
std::unique_ptr<Physics> makePhysics(const World& world);

} // namespace usar::sim
