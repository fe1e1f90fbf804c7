// CONTROL: objects of the world, on a world controller's connection. Only GetObjectStates is answered.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/protocol/commands/checked_text.h"

namespace usar::protocol {

enum class ObjectPhysics { None, RigidBody };

struct CreateObject {
    Token class_name; ///< without a package: USARPhysObj (UDK), USARModels (UT2004)
    Name object_name{};
    std::variant<Pose, Token> start{}; ///< a pose in the map frame, or the name of a start point
    std::optional<Vec3> scale{};
    std::optional<ObjectPhysics> physics{};
    std::optional<bool> permanent{}; ///< stays when the controller leaves
    Text memory{};
    Name material{};
    bool operator==(const CreateObject&) const = default;
};

struct KillObject {
    Token object_name;
    bool operator==(const KillObject&) const = default;
};
/// All objects, or all in a box of the map frame.
struct Box {
    Vec3 min_m = Vec3::Zero();
    Vec3 max_m = Vec3::Zero();
    bool operator==(const Box&) const = default;
};
struct KillAllObjects {
    std::optional<Box> within{};
    bool operator==(const KillAllObjects&) const = default;
};

struct PlaceObject {
    Token object_name;
    Pose object_in_map{};
    bool operator==(const PlaceObject&) const = default;
};
struct ShiftObject {
    Token object_name;
    Pose shift{}; ///< by how much, in the directions of the map frame
    bool operator==(const ShiftObject&) const = default;
};
struct SpinObject {
    Token object_name;
    Vec3 rates_rad_s = Vec3::Zero(); ///< roll, pitch, yaw
    bool operator==(const SpinObject&) const = default;
};
struct RunConveyor {
    Token object_name;
    double speed_m_s = 0.0;
    bool operator==(const RunConveyor&) const = default;
};

/// Way points: added, cleared, and followed at a speed or within a time.
struct AddWaypoints {
    Token object_name;
    std::vector<Vec3> points_in_map_m{};
    bool operator==(const AddWaypoints&) const = default;
};
struct ClearWaypoints {
    Token object_name;
    bool operator==(const ClearWaypoints&) const = default;
};
struct WaypointSpeed {
    double speed_m_s = 0.0;
    bool operator==(const WaypointSpeed&) const = default;
};
struct FollowWaypoints {
    Token object_name;
    std::variant<WaypointSpeed, Seconds> pace{};
    std::optional<bool> loop{};
    std::optional<bool> reset_on_clear{};
    std::optional<bool> moving{};
    bool operator==(const FollowWaypoints&) const = default;
};

/// GetSTA: without a name all objects, or all of a class.
struct GetObjectStates {
    Name object_name{};
    Name class_name{};
    bool operator==(const GetObjectStates&) const = default;
};

} // namespace usar::protocol
