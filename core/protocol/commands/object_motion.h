// CONTROL commands that move an object of the world, at once, steadily or along a path.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/commands/world_control.h"

namespace usar::protocol {

/// AbsMove: moves an object to a pose.
/// On the wire: `CONTROL {Type AbsMove} {Name B1} {Location 3,2,-1} {Rotation 0,0,1.5}`.
struct PlaceObject {
    Token object_name;
    /// Meters and radians; the wire has Location and Rotation in the server's frame.
    Pose object_in_map{};
    bool operator==(const PlaceObject&) const = default;

    static constexpr auto& word = control_word;
    static void segments(auto& io, auto& place) {
        controlSegments(io, "AbsMove", place.object_name);
        io.pose(place.object_in_map);
    }
};
/// RelMove: moves an object relative to its pose.
/// On the wire: `CONTROL {Type RelMove} {Name B1} {Location 0.5,0,0} {Rotation 0,0,0}`.
struct ShiftObject {
    Token object_name;
    Pose shift{}; ///< displacement along the axes of the map frame
    bool operator==(const ShiftObject&) const = default;

    static constexpr auto& word = control_word;
    static void segments(auto& io, auto& shift) {
        controlSegments(io, "RelMove", shift.object_name);
        io.pose(shift.shift);
    }
};
/// Rotate: makes an object rotate steadily.
/// On the wire: `CONTROL {Type Rotate} {Name B1} {Speed 0.25,-0.5,1}`.
struct SpinObject {
    Token object_name;
    Vec3 rates_rad_s = Vec3::Zero(); ///< roll, pitch and yaw rates
    bool operator==(const SpinObject&) const = default;

    static constexpr auto& word = control_word;
    static void segments(auto& io, auto& spin) {
        controlSegments(io, "Rotate", spin.object_name);
        io.position(control_speed, spin.rates_rad_s);
    }
};
/// Conveyor: sets the speed of a conveyor belt.
/// On the wire: `CONTROL {Type Conveyor} {Name Belt1} {Speed 0.5}`.
struct RunConveyor {
    Token object_name;
    double speed_m_s = 0.0;
    bool operator==(const RunConveyor&) const = default;

    static constexpr auto& word = control_word;
    static void segments(auto& io, auto& conveyor) {
        controlSegments(io, "Conveyor", conveyor.object_name);
        io.number(control_speed, conveyor.speed_m_s);
    }
};

/// AddWP: appends points to the path of an object.
/// On the wire: `CONTROL {Type AddWP} {Name B1} {WP 1,2,1.5;3,2,0}`.
struct AddWaypoints {
    Token object_name;
    /// Separated by semicolons on the wire; an empty list is written as an empty WP.
    std::vector<Vec3> points_in_map_m{};
    bool operator==(const AddWaypoints&) const = default;

    static constexpr auto& word = control_word;
    static void segments(auto& io, auto& add) {
        controlSegments(io, "AddWP", add.object_name);
        io.points({"WP", "way points x,y,z;x,y,z in meters"}, add.points_in_map_m);
    }
};
/// ClearWP: removes the path of an object.
/// Whether the object then returns to its place is up to SetWP's ResetOnClear.
/// On the wire: `CONTROL {Type ClearWP} {Name B1}`.
struct ClearWaypoints {
    Token object_name;
    bool operator==(const ClearWaypoints&) const = default;

    static constexpr auto& word = control_word;
    static void segments(auto& io, auto& clear) { controlSegments(io, "ClearWP", clear.object_name); }
};
/// A constant speed along a path, as opposed to a time for the whole path.
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

    static constexpr auto& word = control_word;
    static void segments(auto& io, auto& follow) {
        controlSegments(io, "SetWP", follow.object_name);
        io.pace(control_speed, {"Time", "seconds for the whole way"}, follow.pace);
        io.flag({"Loop", "goes round for ever"}, follow.loop);
        io.flag({"ResetOnClear", "back to its place when the way is cleared"}, follow.reset_on_clear);
        io.flag({"Moving", "starts at once"}, follow.moving);
    }
};

} // namespace usar::protocol
