// What changes in a world beside the robots: things that can be pushed or are moved about, and what tags remember.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/protocol/commands/trace.h"
#include "core/sim/physics.h"
#include "core/sim/world.h"

namespace usar::sim {

/// A thing that is carried along instead of left to physics: along way points, or turning where it is.
struct ObjectMotion {
    Vec3 spin_rad_s = Vec3::Zero(); ///< roll, pitch, yaw rates
    std::vector<Vec3> waypoints_in_map_m;
    std::size_t next_waypoint = 0;
    double speed_m_s = 0.0;
    bool loop = false;
    bool moving = false;

    bool carries() const { return !spin_rad_s.isZero() || (moving && next_waypoint < waypoints_in_map_m.size()); }
};

/// A thing where it is now.
struct SceneObject {
    std::string name;
    std::string class_name;
    BodyId body;
    Pose body_in_map;
    std::vector<BodyPart> parts{}; ///< as cameras see it
    Vec3 size_m = Vec3::Zero();    ///< of its bounding box along its own axes
    double radius_m = 0.0;         ///< of a sphere that holds it
    std::string memory{};
    std::optional<std::uint32_t> goes_with{}; ///< the client with whom it leaves the world
    ObjectMotion motion{};
    std::optional<BodyId> belt{}; ///< of a conveyor
};

/// What a robot under TRACE left behind.
struct TraceMark {
    std::string robot_name;
    protocol::TraceColor color = protocol::TraceColor::Red;
    Vec3 position_in_map_m = Vec3::Zero();
    bool operator==(const TraceMark&) const = default;
};

/// Owned by a Simulation, which refreshes the poses at each tick.
struct Scene {
    std::vector<SceneObject> objects;
    std::vector<RfidTag> tags;
    std::vector<TraceMark> trace_marks{}; ///< in order of time, the newest 20,000 at least
};

/// Adds what the world begins with to the physics.
Scene makeScene(const World& world, Physics& physics);
/// One object more.
SceneObject& addObject(Scene& scene, Physics& physics, const WorldObject& object);
void removeObject(const SceneObject& object, Physics& physics);
/// Both its body and its belt, at rest.
void placeObject(SceneObject& object, Physics& physics, const Pose& body_in_map);
void addMark(Scene& scene, TraceMark mark);
/// The poses as physics has them now.
void refresh(Scene& scene, const Physics& physics);
/// Carries what is on its way.
void carryObjects(Scene& scene, Physics& physics, Seconds dt);

} // namespace usar::sim
