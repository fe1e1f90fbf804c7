// Rigid bodies on a world's still parts: the one interface that a physics engine has to fill. Map frame (z up), SI
// units. No engine header is visible here; see robots-and-worlds 6 for the choice of Bullet.
#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/sim/articulation.h"
#include "core/sim/world.h"

namespace usar::sim {

struct BodyId {
    std::uint32_t value = 0;
    auto operator<=>(const BodyId&) const = default;
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
    Vec3 point_in_body_m = Vec3::Zero(); ///< in the frame of the link that was touched
    double impulse_n_s = 0.0;            ///< along the normal
    double closing_speed_m_s = 0.0;      ///< before the step, positive when approaching
    int link = -1;                       ///< -1: the base
    Vec3 normal_in_map = Vec3::UnitZ();  ///< out of what was touched
};

/// Deterministic on one build: the same calls give the same bits. Single-threaded; owned by a Simulation.
class Physics {
public:
    virtual ~Physics() = default;

    virtual BodyId add(const BodyDescription& description, const Pose& body_in_map) = 0;
    /// Featherstone's reduced coordinates; all joints at 0 and without motors. The base is what `state`, `apply`,
    /// `place` and `contacts` without a link mean. Links of one body do not touch each other.
    virtual BodyId add(const ArticulatedDescription& description, const Pose& base_in_map) = 0;
    virtual void remove(BodyId body) = 0;
    /// Puts a body somewhere, at rest.
    virtual void place(BodyId body, const Pose& body_in_map) = 0;
    /// A body that may sleep is frozen after two seconds of rest, until something moves it: contacts alone let it creep
    /// by millimeters a minute. Forces on a sleeping body have no effect, so one that pushes must not sleep.
    virtual void letSleep(BodyId body, bool allowed) = 0;
    /// True while the body sits inside still parts of the world or another body, or under the ground.
    virtual bool isStuck(BodyId body) = 0;

    virtual BodyState state(BodyId body) const = 0;
    virtual BodyState state(BodyId body, std::size_t link) const = 0;
    virtual JointState joint(BodyId body, std::size_t link) const = 0;
    virtual void setMotor(BodyId body, std::size_t link, const JointMotor& motor) = 0;
    /// Of a still body: what lies on it is carried along, as by a belt and as far as friction can; the body stays.
    virtual void runSurface(BodyId body, const Vec3& velocity_in_body_m_s) = 0;
    /// Acts during the next step only; adds up.
    virtual void apply(BodyId body, const Vec3& force_in_map_n, const Vec3& torque_in_map_n_m) = 0;
    /// One fixed step under gravity (9.81 m/s2).
    virtual void step(Seconds dt) = 0;
    /// Valid until the next step.
    virtual std::span<const Contact> contacts(BodyId body) const = 0;

    /// Distance to the first movable body but `except`; `nearest_m` on a miss and beyond it. `direction` is a unit
    /// vector. The engine tests a piece of `maximum_m`, to whose length it owes its last digits; `nearest_m` is not
    /// above it.
    virtual double castAtBodies(const Vec3& origin_m, const Vec3& direction, double maximum_m, double nearest_m,
                                BodyId except) const = 0;
    /// Whether a movable body but `except` may reach into a box; where it denies, there is none.
    virtual bool hasBodies(const Eigen::AlignedBox3d& box_in_map_m, BodyId except) const = 0;
    /// From a point to the nearest body's origin but that of `except`; infinite when there is none.
    virtual double distanceToBodies_m(const Vec3& point_m, BodyId except) const = 0;
};

inline constexpr double gravity_m_s2 = 9.81;

/// Bullet, double precision. `world` must outlive it: its heights are not copied.
std::unique_ptr<Physics> makePhysics(const World& world);

} // namespace usar::sim
