// The commands by which the user places objects in the world and moves them, and their height above the ground.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "core/base/geometry.h"
#include "core/base/result.h"
#include "core/mapping/height_map.h"
#include "core/protocol/command.h"
#include "core/protocol/info/game_info.h"

namespace usar::mission {

/// The sources of ground height, best first. Lengths are in meters in the map frame. It only refers to data that others
/// own, so create it for a single query.
struct GroundSources {
    /// Height of the embedded simulator's terrain; empty without one, and nullopt for a point of unknown height.
    std::function<std::optional<double>(const Vec2& point_in_map_m)> terrain_m{};
    const mapping::HeightTiles* tiles = nullptr; ///< ground scanned by a robot; nullptr: no robot
    double cell_size_m = 0.25;                   ///< size of a cell of `tiles`
    std::span<const protocol::StartPose> start_poses{};
};

/// Returns the height of the ground at a point in the map frame: that of the terrain, else of the scan, else of the
/// nearest start pose, else 0.
double groundHeight_m(const GroundSources& sources, const Vec2& at_m);

/// Height of the ground at a point of the map frame, in meters.
using GroundHeight = std::function<double(const Vec2& point_in_map_m)>;

/// An object that is to be put into the world.
struct NewObject {
    std::string class_name;
    std::string name;
    Vec3 size_m = Vec3::Ones(); ///< along its own axes, scaled
    Vec3 scale = Vec3::Ones();  ///< factors relative to the size of its class
    bool conveyor = false;      ///< true: it stands on the ground and does not fall
};

/// Returns the name as it is written in a command; "unnamed" for a name that a protocol line cannot contain.
protocol::Token tokenOf(const std::string& name);

/// Returns "Crate" for the class name "USARPhysObj.Crate".
inline std::string withoutPackage(const std::string& class_name) {
    return class_name.substr(class_name.rfind('.') + 1);
}

/// Creates the object standing on the ground at `at_m`; an object that can fall starts 2 cm higher, so that it does not
/// start inside the ground. Fails if a protocol line cannot contain the class name.
Result<protocol::CreateObject> placed(const NewObject& object, const Vec2& at_m, double ground_m);

/// Returns the pose of an object moved to another place, at the same height above the ground as before.
Pose movedTo(const Pose& body_in_map, const Vec2& center_m, const GroundHeight& ground);
/// Returns a waypoint at the object's present height above the ground, in meters in the map frame.
Vec3 waypointAt(const Pose& body_in_map, const Vec2& at_m, const GroundHeight& ground);

/// Motion of an object along its waypoints, or of a conveyor's belt.
struct Motion {
    double speed_m_s = 0.0; ///< negative runs a belt backward; along waypoints only the magnitude counts
    bool loop = false;      ///< true: from the last waypoint it starts again
    bool moving = true;     ///< false: it stops
};

/// Starts or stops an object along its waypoints; a conveyor without waypoints runs its belt.
protocol::Command motionOf(const std::string& name, bool is_conveyor, bool has_way, const Motion& motion);

} // namespace usar::mission
