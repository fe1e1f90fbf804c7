// SET commands for sensors and effecters. A server accepts one SET per tick; UT2004 answers with RES, UDK does not
// answer.
#pragma once

#include "core/base/geometry.h"
#include "core/protocol/commands/checked_text.h"

namespace usar::protocol {

/// POSE of an INS: sets the estimated pose; a robot obeys only at rest.
/// On the wire: `SET {Type INS} {Name INS} {Opcode POSE} {Params 1,2,-3,0.5,-0.25,1}`.
struct SetInsPose {
    Name sensor_name = "INS";
    Pose base_in_map{};
    bool operator==(const SetInsPose&) const = default;
};

/// RESET: sets an Odometry to 0,0,0 and an Encoder to 0. An empty name means all sensors of the type.
/// On the wire: `SET {Type Odometry} {Name Odometry} {Opcode RESET}`.
struct ResetSensor {
    Token type;
    Name sensor_name{};
    bool operator==(const ResetSensor&) const = default;
};

/// SCAN: requests one measurement from a RangeScanner, RangeImager, IRScanner or Acoustic that does not measure
/// periodically.
/// On the wire: `SET {Type RangeImager} {Name kinect} {Opcode SCAN}`.
struct ScanNow {
    Token type;
    Name sensor_name{};
    bool operator==(const ScanNow&) const = default;
};

/// Read of an RFID reader: asks for the memory of a tag in reach.
/// On the wire: `SET {Type RFID} {Name RFID} {Opcode Read} {Params 118}`.
struct ReadTag {
    Token tag_id;
    Name reader_name{};
    bool operator==(const ReadTag&) const = default;
};
/// Write of an RFID reader: stores a text in a tag in reach.
/// On the wire: `SET {Type RFID} {Name RFID} {Opcode Write} {Params 118 visited by robot 2}`.
struct WriteTag {
    Token tag_id;
    Text memory{};
    Name reader_name{};
    bool operator==(const WriteTag&) const = default;
};
/// Release of an RFIDReleaser: drops a tag.
/// On the wire: `SET {Type RFIDReleaser} {Name Gun} {Opcode Release}`.
struct ReleaseTag {
    Name releaser_name{};
    bool operator==(const ReleaseTag&) const = default;
};
/// TagsRemaining of an RFIDReleaser: asks how many tags are left.
/// On the wire: `SET {Type RFIDReleaser} {Name Gun} {Opcode TagsRemaining}`.
struct CountTags {
    Name releaser_name{};
    bool operator==(const CountTags&) const = default;
};

/// Actions of UDK's grippers. Grip and LetGo are sent as GRIP with 1 and 0.
enum class GripperAction { Open, Close, Grip, LetGo };
/// On the wire: `SET {Type Gripper} {Name G1} {Opcode GRIP} {Params 1}`.
struct UseGripper {
    GripperAction action = GripperAction::Open;
    Name gripper_name{};
    bool operator==(const UseGripper&) const = default;
};
/// On the wire: `SET {Type ToolChanger} {Name TC1} {Opcode OPEN}`.
struct UseToolChanger {
    bool open = true;
    Name changer_name{};
    bool operator==(const UseToolChanger&) const = default;
};

/// Any other SET. A line that equals one of the structs above reads back as that struct.
/// On the wire: `SET {Type Siren} {Name S} {Opcode LOUD} {Params at 3 o'clock}`.
struct SetItem {
    Token type;
    Token opcode;
    Name item_name{};
    Text parameters{};
    bool operator==(const SetItem&) const = default;
};

} // namespace usar::protocol
