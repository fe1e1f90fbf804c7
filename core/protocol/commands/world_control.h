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
/// On the wire: `CONTROL {Type Create} {ClassName Box} {Name B1} {Location 1,2,1.5} {Rotation 0,0,0.5} {Scale 1,1,2}`.
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

/// On the wire: `CONTROL {Type Kill} {Name B1}`.
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
/// On the wire: `CONTROL {Type KillAll} {MinPos 0,-1,0} {MaxPos 5,5,4}`.
struct KillAllObjects {
    std::optional<Box> within{};
    bool operator==(const KillAllObjects&) const = default;
};

/// AbsMove: moves an object to a pose.
/// On the wire: `CONTROL {Type AbsMove} {Name B1} {Location 3,2,-1} {Rotation 0,0,1.5}`.
struct PlaceObject {
    Token object_name;
    Pose object_in_map{};
    bool operator==(const PlaceObject&) const = default;
};
/// RelMove: moves an object relative to its pose.
/// On the wire: `CONTROL {Type RelMove} {Name B1} {Location 0.5,0,0} {Rotation 0,0,0}`.
struct ShiftObject {
    Token object_name;
    Pose shift{}; ///< displacement along the axes of the map frame
    bool operator==(const ShiftObject&) const = default;
};
/// Rotate: makes an object rotate steadily.
/// On the wire: `CONTROL {Type Rotate} {Name B1} {Speed 0.25,-0.5,1}`.
struct SpinObject {
    Token object_name;
    Vec3 rates_rad_s = Vec3::Zero(); ///< roll, pitch and yaw rates
    bool operator==(const SpinObject&) const = default;
};
/// Conveyor: sets the speed of a conveyor belt.
/// On the wire: `CONTROL {Type Conveyor} {Name Belt1} {Speed 0.5}`.
struct RunConveyor {
    Token object_name;
    double speed_m_s = 0.0;
    bool operator==(const RunConveyor&) const = default;
};

/// AddWP: appends points to the path of an object.
/// On the wire: `CONTROL {Type AddWP} {Name B1} {WP 1,2,1.5;3,2,0}`.
struct AddWaypoints {
    Token object_name;
    std::vector<Vec3> points_in_map_m{};
    bool operator==(const AddWaypoints&) const = default;
};
/// ClearWP: removes the path of an object.
/// On the wire: `CONTROL {Type ClearWP} {Name B1}`.
struct ClearWaypoints {
    Token object_name;
    bool operator==(const ClearWaypoints&) const = default;
};
struct WaypointSpeed {
    double speed_m_s = 0.0;
    bool operator==(const WaypointSpeed&) const = default;
};
/// SetWP: makes an object follow its path.
/// On the wire: `CONTROL {Type SetWP} {Name B1} {Time 10} {Loop false} {ResetOnClear true} {Moving true}`.
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
/// On the wire: `CONTROL {Type GetSTA} {Name B1} {ClassName Box}`.
struct GetObjectStates {
    Name object_name{};
    Name class_name{};
    bool operator==(const GetObjectStates&) const = default;
};

} // namespace usar::protocol
