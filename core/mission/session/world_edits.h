// The commands by which a person puts objects into the world and moves them: how high above the ground, and how.
#pragma once

#include <functional>
#include <string>

#include "core/base/geometry.h"
#include "core/base/result.h"
#include "core/protocol/command.h"

namespace usar::mission {

/// Height of the ground at a point of the map frame, in meters.
using GroundHeight = std::function<double(const Vec2& point_in_map_m)>;

/// An object that is to be put into the world.
struct NewObject {
    std::string class_name;
    std::string name;
    Vec3 size_m = Vec3::Ones(); ///< along its own axes, scaled
    Vec3 scale = Vec3::Ones();  ///< factors relative to the size of its class
    bool conveyor = false;      ///< it stands on the ground and does not fall
};

/// The word for an object in a command; a name that no line can carry becomes "unnamed".
protocol::Token tokenOf(const std::string& name);

/// Creates the object standing on the ground at `at_m`; one that falls begins 2 cm higher, so that none begins inside
/// the ground. Fails on a class name that no line can carry.
Result<protocol::CreateObject> placed(const NewObject& object, const Vec2& at_m, double ground_m);

/// The pose of an object that is moved to another place, as high over the ground there as it was before.
Pose movedTo(const Pose& body_in_map, const Vec2& center_m, const GroundHeight& ground);
/// A way point, as high over the ground as the object is now.
Vec3 waypointAt(const Pose& body_in_map, const Vec2& at_m, const GroundHeight& ground);

/// How an object goes along its way.
struct Motion {
    double speed_m_s = 0.0; ///< negative runs a belt backward; along a way only the amount counts
    bool loop = false;      ///< the way begins anew at its end
    bool moving = true;     ///< false: it stops
};

/// Starts or stops an object along its way points; a conveyor that has none runs its belt.
protocol::Command motionOf(const std::string& name, bool is_conveyor, bool has_way, const Motion& motion);

} // namespace usar::mission
