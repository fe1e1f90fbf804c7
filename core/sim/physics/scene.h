// The part of a world that changes during a simulation, apart from the robots: movable objects, RFID tags' memory and
// TRACE marks.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/protocol/commands/trace.h"
#include "core/sim/physics/physics.h"
#include "core/sim/world/world.h"

namespace usar::sim {

/// Kinematic motion of an object, which replaces physics for it: along waypoints, spinning in place, or both.
struct ObjectMotion {
    Vec3 spin_rad_s = Vec3::Zero(); ///< roll, pitch and yaw rates
    std::vector<Vec3> waypoints_in_map_m{};
    std::size_t next_waypoint = 0; ///< index of the waypoint it heads for; the number of waypoints after the last one
    double speed_m_s = 0.0;
    bool loop = false;   ///< starts again at the first waypoint after the last one
    bool moving = false; ///< follows the waypoints; the spin acts in any case

    /// True while the object must be moved at each step.
    bool carries() const { return !spin_rad_s.isZero() || (moving && next_waypoint < waypoints_in_map_m.size()); }
};

/// An object of the world in its current state.
struct SceneObject {
    std::string name;
    std::string class_name;
    BodyId body;
    Pose body_in_map;
    std::vector<BodyPart> parts{}; ///< shapes in the body frame, for cameras
    Vec3 size_m = Vec3::Zero();    ///< size of its bounding box along its own axes
    double radius_m = 0.0;         ///< radius of a sphere around the body's origin that encloses it
    std::string memory{};          ///< text given at its creation, reported with its state
    /// Id of the client whose disconnection removes it; nullopt if it is permanent.
    std::optional<std::uint32_t> goes_with{};
    ObjectMotion motion{};
    std::optional<BodyId> belt{}; ///< the moving surface of a conveyor; nullopt for all other objects
};

/// A mark left by a robot under TRACE: the position of its base at that moment.
struct TraceMark {
    std::string robot_name;
    protocol::TraceColor color = protocol::TraceColor::Red;
    Vec3 position_in_map_m = Vec3::Zero();
    bool operator==(const TraceMark&) const = default;
};

/// All that can change in one world. Owned by a Simulation, which refreshes the poses at each tick.
struct Scene {
    std::vector<SceneObject> objects;
    std::vector<RfidTag> tags;
    std::vector<TraceMark> trace_marks{}; ///< oldest first; at least the newest 20,000 are kept
};

/// Adds the world's initial objects to the physics and returns the scene that refers to them.
Scene makeScene(const World& world, Physics& physics);
/// Adds an object to scene and physics. The reference is valid until the list of objects changes.
SceneObject& addObject(Scene& scene, Physics& physics, const WorldObject& object);
/// Removes body and belt from the physics only; the caller erases the object from the scene.
void removeObject(const SceneObject& object, Physics& physics);
/// Moves the object, together with its belt, to a pose, at rest.
void placeObject(SceneObject& object, Physics& physics, const Pose& body_in_map);
/// Appends a mark. When 40,000 are kept, the oldest 20,000 are dropped first.
void addMark(Scene& scene, TraceMark mark);
/// Copies the current poses from the physics into the scene.
void refresh(Scene& scene, const Physics& physics);
/// Moves the objects that have a motion of their own by `dt`.
void carryObjects(Scene& scene, Physics& physics, Seconds dt);

} // namespace usar::sim
