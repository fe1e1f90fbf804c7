// CONTROL commands, which create, move and remove objects of the world. They are sent on the connection of a world
// controller; only GetObjectStates is answered.
#pragma once

#include <optional>
#include <variant>

#include "core/base/geometry.h"
#include "core/protocol/commands/checked_text.h"
#include "core/protocol/commands/description.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

/// A RigidBody falls and can be pushed.
enum class ObjectPhysics { None, RigidBody };
template <>
inline constexpr std::array wire_words<ObjectPhysics> = {WireWord{"None", ObjectPhysics::None},
                                                         WireWord{"RigidBody", ObjectPhysics::RigidBody}};

/// The word that begins every command of this file and of object_motion.h.
inline constexpr CommandWord control_word{"CONTROL",
                                          "makes, moves and removes objects, on a world controller's connection",
                                          "CONTROL {Type Kill} {Name Box1}"};
/// What a CONTROL does is its Type, which is a mark.
inline constexpr Key control_type{"Type", "what to do with the object"};
inline constexpr Key object_key{"Name", "the object"};
inline constexpr Key object_class{"ClassName", "its class"};
inline constexpr Key control_speed{"Speed", "m/s, or x,y,z in rad/s for Rotate"};

/// Passes Type and Name, with which almost every CONTROL begins.
void controlSegments(auto& io, std::string_view type, auto& object_name) {
    io.mark(control_type, type);
    io.text(object_key, object_name);
}

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

    static constexpr auto& word = control_word;
    static void segments(auto& io, auto& create) {
        io.mark(control_type, "Create");
        io.text(object_class, create.class_name);
        io.text(object_key, create.object_name);
        io.start({"Start", "a start point by name"}, create.start);
        io.vector({"Scale", "x,y,z"}, create.scale);
        io.choice({"Physics", "RigidBody falls and can be pushed"}, create.physics);
        io.flag({"Permanent", "stays when this connection ends"}, create.permanent);
        io.text({"Memory", "free text kept with the object"}, create.memory);
        io.text({"Material", "its material"}, create.material);
    }
};

/// Kill: removes one object by its name.
/// On the wire: `CONTROL {Type Kill} {Name B1}`.
struct KillObject {
    Token object_name;
    bool operator==(const KillObject&) const = default;

    static constexpr auto& word = control_word;
    static void segments(auto& io, auto& kill) { controlSegments(io, "Kill", kill.object_name); }
};
/// An axis-aligned box in the map frame.
struct Box {
    /// The corner with the smallest coordinates; `max_m` has the largest.
    Vec3 min_m = Vec3::Zero();
    Vec3 max_m = Vec3::Zero();
    bool operator==(const Box&) const = default;
};
/// Converts a box between the wire's frame and ours. Where a sign changes, minimum and maximum swap.
inline Box acrossWire(const Box& box) {
    const Vec3 low_m = acrossWire(box.max_m);
    const Vec3 high_m = acrossWire(box.min_m);
    return {{box.min_m.x(), low_m.y(), low_m.z()}, {box.max_m.x(), high_m.y(), high_m.z()}};
}
/// KillAll: removes all objects, or those in a box.
/// On the wire: `CONTROL {Type KillAll} {MinPos 0,-1,0} {MaxPos 5,5,4}`.
struct KillAllObjects {
    /// Absent: the command is not limited to a place.
    std::optional<Box> within{};
    bool operator==(const KillAllObjects&) const = default;

    static constexpr auto& word = control_word;
    static void segments(auto& io, auto& kill) {
        io.mark(control_type, "KillAll");
        io.box({"MinPos", "x,y,z: a corner of the box to clear"}, {"MaxPos", "x,y,z: the opposite corner"},
               kill.within);
    }
};

/// GetSTA: asks for one object, all objects of a class, or, if both names are empty, all objects. The answer is
/// WorldObjects.
/// On the wire: `CONTROL {Type GetSTA} {Name B1} {ClassName Box}`.
struct GetObjectStates {
    Name object_name{};
    Name class_name{};
    bool operator==(const GetObjectStates&) const = default;

    static constexpr auto& word = control_word;
    static void segments(auto& io, auto& get) {
        controlSegments(io, "GetSTA", get.object_name);
        io.text(object_class, get.class_name);
    }
};

} // namespace usar::protocol
