#include "core/protocol/command_reader.h"

#include <algorithm>
#include <array>

#include "core/protocol/commands/drive_fields.h"
#include "core/protocol/commands/path_node_fields.h"
#include "core/protocol/commands/robot_fields.h"
#include "core/protocol/commands/set_fields.h"
#include "core/protocol/commands/world_fields.h"

namespace usar::protocol {

namespace {

using Read = Command (*)(LineIn&);

/// A command to read values into. Tokens cannot be empty and begin as "?", which is replaced when the line is read; if
/// the line is refused, the command is discarded.
template <class T>
T blank() {
    if constexpr (std::is_default_constructible_v<T>)
        return T{};
    else if constexpr (requires { T{"?"}; })
        return T{"?"};
    else
        return T{"?", "?"};
}

template <class T>
Command read(LineIn& line) {
    T value = blank<T>();
    fields(line, value);
    return value;
}

/// A table row: a line that has a segment with this key, and this word as its value (empty means any), is read by
/// `read`. The first matching row wins.
struct Row {
    std::string_view key;
    std::string_view word;
    Read read;
};

Command readByRow(LineIn& line, std::span<const Row> rows, std::string_view refusal) {
    const auto fits = [&line](const Row& row) {
        const Segment* const segment = line.segments().find(row.key);
        return segment && (row.word.empty() || sameWord(segment->value, row.word));
    };
    const auto row = std::ranges::find_if(rows, fits);
    if (row != rows.end())
        return row->read(line);
    line.refuse(line.segments().line(), std::string(refusal));
    return {};
}

/// Aerial keys come first because Iridium's stop button sends the keys of all vehicles at once. A Normalized alone is a
/// drive of any kind without values.
constexpr std::array drive_rows = {
    Row{"AltitudeVelocity", "", read<AerialDrive>},
    Row{"LinearVelocity", "", read<AerialDrive>},
    Row{"LateralVelocity", "", read<AerialDrive>},
    Row{"RotationalVelocity", "", read<AerialDrive>},
    Row{"PitchAngle", "", read<AerialDrive>},
    Row{"RollAngle", "", read<AerialDrive>},
    Row{"Left", "", read<SkidDrive>},
    Row{"Right", "", read<SkidDrive>},
    Row{"Speed", "", read<AckermannDrive>},
    Row{"FrontSteer", "", read<AckermannDrive>},
    Row{"RearSteer", "", read<AckermannDrive>},
    Row{"WheelNumber", "", read<OmniDrive>},
    Row{"Propeller", "", read<NauticDrive>},
    Row{"Rudder", "", read<NauticDrive>},
    Row{"SternPlane", "", read<NauticDrive>},
    Row{"Name", "", read<JointDrive>},
    Row{"Normalized", "", read<AerialDrive>},
    Row{"Light", "", read<DriveSwitches>},
    Row{"Flip", "", read<DriveSwitches>},
};

Command readDrive(LineIn& line) {
    if (line.segments().all().empty())
        return DriveSwitches{};
    return readByRow(line, drive_rows, "no key of this DRIVE is known");
}

constexpr std::array package_rows = {
    Row{"Rotation", "", read<PackageRotation>},
    Row{"Name", "", read<PackageDrive>},
};
Command readPackage(LineIn& line) {
    return readByRow(line, package_rows, "MISPKG needs a Name");
}

constexpr std::array control_rows = {
    Row{"Type", "Create", read<CreateObject>},    Row{"Type", "Kill", read<KillObject>},
    Row{"Type", "KillAll", read<KillAllObjects>}, Row{"Type", "AbsMove", read<PlaceObject>},
    Row{"Type", "RelMove", read<ShiftObject>},    Row{"Type", "Rotate", read<SpinObject>},
    Row{"Type", "Conveyor", read<RunConveyor>},   Row{"Type", "AddWP", read<AddWaypoints>},
    Row{"Type", "ClearWP", read<ClearWaypoints>}, Row{"Type", "SetWP", read<FollowWaypoints>},
    Row{"Type", "GetSTA", read<GetObjectStates>},
};
Command readControl(LineIn& line) {
    return readByRow(line, control_rows, "this Type of CONTROL is not known");
}

constexpr std::array move_rows = {
    Row{"Action", "New", read<WalkTo>},
    Row{"Action", "Append", read<WalkTo>},
    Row{"Action", "Pause", read<PauseWalk>},
    Row{"Action", "Resume", read<ResumeWalk>},
};
Command readMove(LineIn& line) {
    return readByRow(line, move_rows, "MOVE needs an Action: New, Append, Pause or Resume");
}

/// A table row that matches by Type and Opcode; an empty word matches any.
struct SetRow {
    std::string_view type;
    std::string_view opcode;
    Read read;
};
constexpr std::array set_rows = {
    SetRow{"INS", "POSE", read<SetInsPose>},
    SetRow{"Joint", "", read<SetJoint>},
    SetRow{"Camera", "Zoom", read<ZoomCamera>},
    SetRow{"Camera", "FOV", read<ZoomCamera>},
    SetRow{"RFID", "Read", read<ReadTag>},
    SetRow{"RFID", "Write", read<WriteTag>},
    SetRow{"RFIDReleaser", "Release", read<ReleaseTag>},
    SetRow{"RFIDReleaser", "TagsRemaining", read<CountTags>},
    SetRow{"Gripper", "GRIP", read<UseGripper>},
    SetRow{"Gripper", "OPEN", read<UseGripper>},
    SetRow{"Gripper", "CLOSE", read<UseGripper>},
    SetRow{"ToolChanger", "OPEN", read<UseToolChanger>},
    SetRow{"ToolChanger", "CLOSE", read<UseToolChanger>},
    SetRow{"", "RESET", read<ResetSensor>},
    SetRow{"", "SCAN", read<ScanNow>},
    SetRow{"", "", read<SetItem>},
};
/// Rows for a SET without an Opcode.
constexpr std::array view_rows = {
    Row{"Config", "", read<SetViewports>},
    Row{"Robot", "", read<AttachCamera>},
    Row{"Client", "", read<DetachCamera>},
};

Command readSet(LineIn& line) {
    const std::string_view type = line.segments().value("Type");
    const std::string_view opcode = line.segments().value("Opcode");
    const auto fits = [&](const SetRow& row) {
        return (row.type.empty() || sameWord(row.type, type)) && (row.opcode.empty() || sameWord(row.opcode, opcode));
    };
    if (opcode.empty() && (sameWord(type, "Camera") || sameWord(type, "Viewports")))
        return readByRow(line, view_rows, "SET without an Opcode");
    return std::ranges::find_if(set_rows, fits)->read(line);
}

struct CommandRow {
    std::string_view word;
    Read read;
};
constexpr std::array rows = {
    CommandRow{"DRIVE", readDrive},
    CommandRow{"STEP", read<Step>},
    CommandRow{"MULTIDRIVE", read<MultiDrive>},
    CommandRow{"SET", readSet},
    CommandRow{"MISPKG", readPackage},
    CommandRow{"MISSPKG", readPackage},
    CommandRow{"ACT", read<ActuatorDrive>},
    CommandRow{"GETGEO", read<GetGeometry>},
    CommandRow{"GETCONF", read<GetConfiguration>},
    CommandRow{"INIT", read<Init>},
    CommandRow{"GETSTARTPOSES", read<GetStartPoses>},
    CommandRow{"STARTPOSES", read<GetStartPoses>},
    CommandRow{"TRACE", read<Trace>},
    CommandRow{"CONTROL", readControl},
    CommandRow{"GETPATHNODES", read<GetPathNodes>},
    CommandRow{"GETCLOSESTPATHNODE", read<GetClosestPathNode>},
    CommandRow{"GOTO", read<GoToNode>},
    CommandRow{"MOVE", readMove},
    CommandRow{"TEST", read<Test>},
    CommandRow{"PAUSE", read<Pause>},
    CommandRow{"LOCKSTEP", read<Lockstep>},
};

} // namespace

Command readCommand(std::string_view line, Diagnostics& diagnostics, Dialect dialect) {
    Segments segments;
    segments.read(line, diagnostics);
    const auto row =
        std::ranges::find_if(rows, [&](const CommandRow& r) { return sameWord(r.word, segments.typeWord()); });
    if (row == rows.end())
        return RawCommand{std::string(line)};
    LineIn in(segments, diagnostics, dialect);
    Command command = row->read(in);
    return in.refused() ? RawCommand{std::string(line)} : std::move(command);
}

} // namespace usar::protocol
