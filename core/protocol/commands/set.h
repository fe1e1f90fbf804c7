// SET of sensors and effecters. A server takes one SET per tick; UT2004 answers with RES, UDK not at all.
#pragma once

#include "core/base/geometry.h"
#include "core/protocol/commands/checked_text.h"

namespace usar::protocol {

/// SET INS POSE: sets the estimate; only a robot at rest obeys.
struct SetInsPose {
    Name sensor_name = "INS";
    Pose base_in_map{};
    bool operator==(const SetInsPose&) const = default;
};

/// RESET: an Odometry goes to 0,0,0, an Encoder to 0. Without a name all of the type are meant.
struct ResetSensor {
    Token type;
    Name sensor_name{};
    bool operator==(const ResetSensor&) const = default;
};

/// SCAN: one measurement of a RangeScanner, RangeImager, IRScanner or Acoustic that does not measure by itself.
struct ScanNow {
    Token type;
    Name sensor_name{};
    bool operator==(const ScanNow&) const = default;
};

/// RFID tags in reach of the reader.
struct ReadTag {
    Token tag_id;
    Name reader_name{};
    bool operator==(const ReadTag&) const = default;
};
struct WriteTag {
    Token tag_id;
    Text memory{};
    Name reader_name{};
    bool operator==(const WriteTag&) const = default;
};
/// RFIDReleaser: drops a tag, or asks how many are left.
struct ReleaseTag {
    Name releaser_name{};
    bool operator==(const ReleaseTag&) const = default;
};
struct CountTags {
    Name releaser_name{};
    bool operator==(const CountTags&) const = default;
};

/// UDK's hands. Grip and LetGo are GRIP with 1 and 0.
enum class GripperAction { Open, Close, Grip, LetGo };
struct UseGripper {
    GripperAction action = GripperAction::Open;
    Name gripper_name{};
    bool operator==(const UseGripper&) const = default;
};
struct UseToolChanger {
    bool open = true;
    Name changer_name{};
    bool operator==(const UseToolChanger&) const = default;
};

/// Everything else that can be set. What says the same as a struct above reads back as that one.
struct SetItem {
    Token type;
    Token opcode;
    Name item_name{};
    Text parameters{};
    bool operator==(const SetItem&) const = default;
};

} // namespace usar::protocol
