// CONTROL commands, which create, move and remove objects of the world. They are sent on the connection of a world
// controller; only GetObjectStates is answered.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/protocol/commands/checked_text.h"

namespace usar::protocol {

/// A RigidBody falls and can be pushed.
enum class ObjectPhysics { None, RigidBody };

/// Create; absent and empty values leave the choice to the server.
struct CreateObject {
    Token class_name; ///< without a package: USARPhysObj (UDK), USARModels (UT2004)
    Name object_name{};
    std::variant<Pose, Token> start{}; ///< a pose in the map frame, or the name of a start point
    std::optional<Vec3> scale{};       ///< factors along x, y, z
    std::optional<ObjectPhysics> physics{};
    std::optional<bool> permanent{}; ///< the object stays when the controller disconnects
    Text memory{};                   ///< free text kept with the object
    Name material{};
    bool operator==(const CreateObject&) const = default;
};

struct KillObject {
    Token object_name;
    bool operator==(const KillObject&) const = default;
};
/// An axis-aligned box in the map frame.
struct Box {
    Vec3 min_m = Vec3::Zero();
    Vec3 max_m = Vec3::Zero();
    bool operator==(const Box&) const = default;
};
/// KillAll: removes all objects, or those in a box.
struct KillAllObjects {
    std::optional<Box> within{};
    bool operator==(const KillAllObjects&) const = default;
};

/// AbsMove: moves an object to a pose.
struct PlaceObject {
    Token object_name;
    Pose object_in_map{};
    bool operator==(const PlaceObject&) const = default;
};
/// RelMove: moves an object relative to its pose.
struct ShiftObject {
    Token object_name;
    Pose shift{}; ///< displacement along the axes of the map frame
    bool operator==(const ShiftObject&) const = default;
};
/// Rotate: makes an object rotate steadily.
struct SpinObject {
    Token object_name;
    Vec3 rates_rad_s = Vec3::Zero(); ///< roll, pitch and yaw rates
    bool operator==(const SpinObject&) const = default;
};
/// Conveyor: sets the speed of a conveyor belt.
struct RunConveyor {
    Token object_name;
    double speed_m_s = 0.0;
    bool operator==(const RunConveyor&) const = default;
};

/// AddWP: appends points to the path of an object.
struct AddWaypoints {
    Token object_name;
    std::vector<Vec3> points_in_map_m{};
    bool operator==(const AddWaypoints&) const = default;
};
/// ClearWP: removes the path of an object.
struct ClearWaypoints {
    Token object_name;
    bool operator==(const ClearWaypoints&) const = default;
};
struct WaypointSpeed {
    double speed_m_s = 0.0;
    bool operator==(const WaypointSpeed&) const = default;
};
/// SetWP: makes an object follow its path.
struct FollowWaypoints {
    Token object_name;
    std::variant<WaypointSpeed, Seconds> pace{}; ///< the speed, or the time for the whole path
    std::optional<bool> loop{};                  ///< repeat the path forever
    std::optional<bool> reset_on_clear{};        ///< return to the initial place when the path is cleared
    std::optional<bool> moving{};                ///< start at once
    bool operator==(const FollowWaypoints&) const = default;
};

/// GetSTA: asks for one object, all objects of a class, or, if both names are empty, all objects. The answer is
/// WorldObjects.
struct GetObjectStates {
    Name object_name{};
    Name class_name{};
    bool operator==(const GetObjectStates&) const = default;
};

} // namespace usar::protocol
