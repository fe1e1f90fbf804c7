// The segments of SET, stated once for writing and reading (see drive_fields.h).
#pragma once

#include "core/protocol/commands/joint.h"
#include "core/protocol/commands/line_in.h"
#include "core/protocol/commands/line_out.h"
#include "core/protocol/commands/set.h"
#include "core/protocol/commands/view.h"

namespace usar::protocol {

/// Writes Type, Name and Opcode in the order that all clients use; when reading, only Name. `opcode` may be empty.
template <class Io, class Type>
void beginSet(Io& io, const Type& type, typename Io::template Ref<Name> name, std::string_view opcode) {
    io.word("SET");
    io.mark("Type", type);
    io.text("Name", name);
    if (!opcode.empty())
        io.mark("Opcode", opcode);
}

inline void fields(LineOut& out, const SetInsPose& set) {
    beginSet(out, "INS", set.sensor_name, "POSE");
    const Pose on_wire = acrossWire(set.base_in_map);
    out.open("Params");
    out.add(on_wire.position_m);
    out.add(",");
    out.add(Vec3(on_wire.roll_rad, on_wire.pitch_rad, on_wire.yaw_rad));
    out.close();
}
void fields(LineIn& in, SetInsPose& set);

template <class Io>
void fields(Io& io, typename Io::template Ref<ResetSensor> set) {
    io.word("SET");
    io.text("Type", set.type);
    io.text("Name", set.sensor_name);
    io.mark("Opcode", "RESET");
}

template <class Io>
void fields(Io& io, typename Io::template Ref<ScanNow> set) {
    io.word("SET");
    io.text("Type", set.type);
    io.text("Name", set.sensor_name);
    io.mark("Opcode", "SCAN");
}

template <class Io>
void fields(Io& io, typename Io::template Ref<ReadTag> set) {
    beginSet(io, "RFID", set.reader_name, "Read");
    io.text("Params", set.tag_id);
}

inline void fields(LineOut& out, const WriteTag& set) {
    beginSet(out, "RFID", set.reader_name, "Write");
    out.open("Params");
    out.add(set.tag_id.text());
    if (!set.memory.empty()) {
        out.add(" ");
        out.add(set.memory.text());
    }
    out.close();
}
void fields(LineIn& in, WriteTag& set);

template <class Io>
void fields(Io& io, typename Io::template Ref<ReleaseTag> set) {
    beginSet(io, "RFIDReleaser", set.releaser_name, "Release");
}

template <class Io>
void fields(Io& io, typename Io::template Ref<CountTags> set) {
    beginSet(io, "RFIDReleaser", set.releaser_name, "TagsRemaining");
}

inline void fields(LineOut& out, const UseGripper& set) {
    const bool grips = set.action == GripperAction::Grip || set.action == GripperAction::LetGo;
    const bool opens = set.action == GripperAction::Open;
    beginSet(out, "Gripper", set.gripper_name, grips ? "GRIP" : opens ? "OPEN" : "CLOSE");
    if (grips)
        out.digit("Params", set.action == GripperAction::Grip);
}
void fields(LineIn& in, UseGripper& set);

inline void fields(LineOut& out, const UseToolChanger& set) {
    beginSet(out, "ToolChanger", set.changer_name, set.open ? "OPEN" : "CLOSE");
}
void fields(LineIn& in, UseToolChanger& set);

template <class Io>
void fields(Io& io, typename Io::template Ref<SetItem> set) {
    io.word("SET");
    io.text("Type", set.type);
    io.text("Name", set.item_name);
    io.text("Opcode", set.opcode);
    io.text("Params", set.parameters);
}

inline void fields(LineOut& out, const SetJoint& set) {
    out.word("SET");
    out.mark("Type", "Joint");
    out.text("Name", set.joint);
    out.choice("Opcode", set.opcode);
    out.open("Params");
    out.add(set.value);
    if (set.steer_rad) {
        out.add(",");
        out.add(acrossWire(*set.steer_rad));
    }
    out.close();
}
void fields(LineIn& in, SetJoint& set);

inline void fields(LineOut& out, const ZoomCamera& set) {
    beginSet(out, "Camera", set.camera_name, "Zoom");
    out.number("Params", set.field_of_view_rad);
}
void fields(LineIn& in, ZoomCamera& set);

template <class Io>
void fields(Io& io, typename Io::template Ref<AttachCamera> set) {
    io.word("SET");
    io.mark("Type", "Camera");
    io.text("Robot", set.robot_name);
    io.text("Name", set.camera_name);
    io.text("Client", set.client_address);
}

template <class Io>
void fields(Io& io, typename Io::template Ref<DetachCamera> set) {
    io.word("SET");
    io.mark("Type", "Camera");
    io.text("Client", set.client_address);
}

template <class Io>
void fields(Io& io, typename Io::template Ref<SetViewports> set) {
    io.word("SET");
    io.mark("Type", "Viewports");
    io.choice("Config", set.layout);
    io.text("Viewport1", set.views[0]);
    io.text("Viewport2", set.views[1]);
    io.text("Viewport3", set.views[2]);
    io.text("Viewport4", set.views[3]);
}

} // namespace usar::protocol
