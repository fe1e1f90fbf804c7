// Rigid bodies on a world's still parts: the one interface that a physics engine has to fill. Map frame (z up), SI
// units. No engine header is visible here; see robots-and-worlds 6 for the choice of Bullet.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/sim/world.h"

namespace usar::sim {

struct BodyId {
    std::uint32_t value = 0;
    auto operator<=>(const BodyId&) const = default;
};

/// Upright in its part's frame: axis along z.
struct CylinderShape {
    double radius_m = 0.0;
    double height_m = 0.0;
};
/// `height_m` is without the two half-spheres at its ends.
struct CapsuleShape {
    double radius_m = 0.0;
    double height_m = 0.0;
};
struct BoxShape {
    Vec3 size_m = Vec3::Zero();
};

/// One convex part of a body. The body frame's origin is its center of mass.
struct BodyPart {
    std::variant<CylinderShape, CapsuleShape, BoxShape> shape;
    Pose part_in_body;
};

struct BodyDescription {
    double mass_kg = 1.0;
    Vec3 inertia_kg_m2 = Vec3::Ones(); ///< about the body's axes
    double friction = 0.9;
    std::vector<BodyPart> parts;
};

struct BodyState {
    Vec3 position_m = Vec3::Zero();
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Vec3 velocity_m_s = Vec3::Zero();
    Vec3 rate_rad_s = Vec3::Zero(); ///< angular velocity, map frame
    Pose pose() const { return Pose::from(position_m, rotation); }
};

enum class Surface { Ground, Plant, Building, Body };

/// One point where a body was pressed during the last step.
struct Contact {
    Surface surface = Surface::Ground;
    Vec3 point_in_body_m = Vec3::Zero();
    double impulse_n_s = 0.0;       ///< along the normal
    double closing_speed_m_s = 0.0; ///< before the step, positive when approaching
};

/// Deterministic on one build: the same calls give the same bits. Single-threaded; owned by a Simulation.
class Physics {
public:
    virtual ~Physics() = default;

    virtual BodyId add(const BodyDescription& description, const Pose& body_in_map) = 0;
    virtual void remove(BodyId body) = 0;
    /// Puts a body somewhere, at rest.
    virtual void place(BodyId body, const Pose& body_in_map) = 0;
    /// A body that may sleep is frozen after two seconds of rest, until something moves it: contacts alone let it creep
    /// by millimeters a minute. Forces on a sleeping body have no effect, so one that pushes must not sleep.
    virtual void letSleep(BodyId body, bool allowed) = 0;
    /// True while the body sits inside still parts of the world or another body, or under the ground.
    virtual bool isStuck(BodyId body) = 0;

    virtual BodyState state(BodyId body) const = 0;
    /// Acts during the next step only; adds up.
    virtual void apply(BodyId body, const Vec3& force_in_map_n, const Vec3& torque_in_map_n_m) = 0;
    /// One fixed step under gravity (9.81 m/s2).
    virtual void step(Seconds dt) = 0;
    /// Valid until the next step.
    virtual std::span<const Contact> contacts(BodyId body) const = 0;

    /// Distance to the first movable body but `except`; `maximum_m` on a miss. `direction` is a unit vector.
    virtual double castAtBodies(const Vec3& origin_m, const Vec3& direction, double maximum_m, BodyId except) const = 0;
    /// From a point to the nearest body's origin but that of `except`; infinite when there is none.
    virtual double distanceToBodies_m(const Vec3& point_m, BodyId except) const = 0;
};

inline constexpr double gravity_m_s2 = 9.81;

/// Bullet, double precision. `world` must outlive it: its heights are not copied.
std::unique_ptr<Physics> makePhysics(const World& world);

} // namespace usar::sim
