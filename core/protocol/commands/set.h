// SET commands for sensors and effecters. A server accepts one SET per tick; UT2004 answers with RES, UDK does not
// answer.
#pragma once

#include "core/base/geometry.h"
#include "core/protocol/commands/checked_text.h"
#include "core/protocol/commands/set_word.h"

namespace usar::protocol {

/// POSE of an INS: sets the estimated pose; a robot obeys only at rest.
/// On the wire: `SET {Type INS} {Name INS} {Opcode POSE} {Params 1,2,-3,0.5,-0.25,1}`.
struct SetInsPose {
    Name sensor_name = "INS";
    /// In our map frame; the line has x, y and z in meters and the three angles in radians in the server's frame.
    Pose base_in_map{};
    bool operator==(const SetInsPose&) const = default;

    static constexpr auto& word = set_word;
    static void segments(auto& io, auto& set) {
        setSegments(io, "INS", set.sensor_name, "POSE");
        io.sixNumbers({"Params", "INS: x,y,z,roll,pitch,yaw"}, set.base_in_map);
    }
};

/// RESET: sets an Odometry to 0,0,0 and an Encoder to 0. An empty name means all sensors of the type.
/// On the wire: `SET {Type Odometry} {Name Odometry} {Opcode RESET}`.
struct ResetSensor {
    Token type;
    Name sensor_name{};
    bool operator==(const ResetSensor&) const = default;

    static constexpr auto& word = set_word;
    /// These types are suggested for completion; any other is sent as it is.
    static constexpr auto usual_types = texts("Odometry", "Encoder");
    static void segments(auto& io, auto& set) {
        io.text({"Type", set_type.help, usual_types}, set.type);
        io.text(set_name, set.sensor_name);
        io.mark(set_opcode, "RESET");
    }
};

/// SCAN: requests one measurement from a RangeScanner, RangeImager, IRScanner or Acoustic that does not measure
/// periodically.
/// On the wire: `SET {Type RangeImager} {Name kinect} {Opcode SCAN}`.
struct ScanNow {
    Token type;
    Name sensor_name{};
    bool operator==(const ScanNow&) const = default;

    static constexpr auto& word = set_word;
    static constexpr auto usual_types = texts("RangeScanner", "RangeImager", "IRScanner", "Acoustic");
    static void segments(auto& io, auto& set) {
        io.text({"Type", set_type.help, usual_types}, set.type);
        io.text(set_name, set.sensor_name);
        io.mark(set_opcode, "SCAN");
    }
};

/// Actions of UDK's grippers. Grip and LetGo are sent as GRIP with 1 and 0.
enum class GripperAction { Open, Close, Grip, LetGo };
template <>
inline constexpr std::array wire_words<GripperAction> = {
    WireWord{"OPEN", GripperAction::Open}, WireWord{"CLOSE", GripperAction::Close},
    WireWord{"GRIP", GripperAction::Grip}, WireWord{"GRIP", GripperAction::LetGo}};
/// OPEN and CLOSE have no parameters. An empty name lets the line go out without Name.
/// On the wire: `SET {Type Gripper} {Name G1} {Opcode GRIP} {Params 1}`.
struct UseGripper {
    GripperAction action = GripperAction::Open;
    Name gripper_name{};
    bool operator==(const UseGripper&) const = default;

    static constexpr auto& word = set_word;
    template <class Io>
    static void segments(Io& io, auto& set) {
        io.mark(set_type, "Gripper");
        io.text(set_name, set.gripper_name);
        io.mark(set_opcode, set.action, wire_words<GripperAction>);
        std::optional<bool> grips;
        if (set.action == GripperAction::Grip || set.action == GripperAction::LetGo)
            grips = set.action == GripperAction::Grip;
        constexpr Key params{"Params", "Gripper: 1 grips, 0 lets go"};
        if (grips)
            io.digit(params, grips);
        else
            io.ignored(params);
        if constexpr (Io::reading)
            if (grips == false)
                set.action = GripperAction::LetGo;
    }
};
/// Opens or closes a tool changer (UDK).
/// On the wire: `SET {Type ToolChanger} {Name TC1} {Opcode OPEN}`.
struct UseToolChanger {
    bool open = true;
    Name changer_name{};
    bool operator==(const UseToolChanger&) const = default;

    static constexpr auto& word = set_word;
    static void segments(auto& io, auto& set) {
        io.mark(set_type, "ToolChanger");
        io.text(set_name, set.changer_name);
        io.mark(set_opcode, set.open, std::array{WireWord{"OPEN", true}, WireWord{"CLOSE", false}});
    }
};

/// Any other SET. A line that equals one of the structs above reads back as that struct.
/// On the wire: `SET {Type Siren} {Name S} {Opcode LOUD} {Params at 3 o'clock}`.
struct SetItem {
    Token type;
    Token opcode;
    Name item_name{};
    Text parameters{};
    bool operator==(const SetItem&) const = default;

    static constexpr auto& word = set_word;
    /// Any SET with an opcode fits; more specific structs are tried before this one.
    static constexpr auto signs = texts("Opcode");
    static void segments(auto& io, auto& set) {
        io.text(set_type, set.type);
        io.text(set_name, set.item_name);
        io.text(set_opcode, set.opcode);
        io.text("Params", set.parameters);
        io.ignored({"Value", "a value that some clients add"});
    }
};

} // namespace usar::protocol
