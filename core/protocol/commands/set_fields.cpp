#include "core/protocol/commands/set_fields.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace usar::protocol {

void fields(LineIn& in, SetInsPose& set) {
    const Segment* const params = in.segments().find("Params");
    std::array<double, 6> n{};
    if (!params || !in.takeNumbersOf(*params, n))
        return in.refuse(in.segments().line(), "SET INS POSE takes exactly six numbers; ignored");
    set.sensor_name = {};
    in.text("Name", set.sensor_name);
    set.base_in_map = acrossWire(Pose{{n[0], n[1], n[2]}, n[3], n[4], n[5]});
}

void fields(LineIn& in, WriteTag& set) {
    std::string_view rest = in.segments().value("Params");
    in.takeText("tag's number in Params", takeWord(rest), set.tag_id);
    in.takeText("text", trimmed(rest), set.memory);
    in.text("Name", set.reader_name);
}

void fields(LineIn& in, UseGripper& set) {
    const std::string_view opcode = in.segments().value("Opcode");
    in.text("Name", set.gripper_name);
    std::optional<bool> grips = true;
    if (sameWord(opcode, "GRIP"))
        in.digit("Params", grips);
    if (sameWord(opcode, "OPEN"))
        set.action = GripperAction::Open;
    else if (sameWord(opcode, "CLOSE"))
        set.action = GripperAction::Close;
    else
        set.action = *grips ? GripperAction::Grip : GripperAction::LetGo;
}

void fields(LineIn& in, UseToolChanger& set) {
    set.open = sameWord(in.segments().value("Opcode"), "OPEN");
    in.text("Name", set.changer_name);
}

/// Params hold the value and, optionally, the steering angle of a wheel.
void fields(LineIn& in, SetJoint& set) {
    in.text("Name", set.joint);
    in.choice("Opcode", set.opcode);
    const Segment* const params = in.segments().find("Params");
    if (!params)
        return in.refuse(in.segments().line(), "SET of a joint needs Params");
    if (params->value.find(',') == std::string_view::npos) {
        set.value = in.numberOf(*params);
    } else {
        const auto [value, steer_rad] = in.numbersOf<2>(*params);
        set.value = value;
        set.steer_rad = acrossWire(steer_rad);
    }
}

/// Also accepts the angle as a segment without a key, as Player's driver sends it.
void fields(LineIn& in, ZoomCamera& set) {
    in.text("Name", set.camera_name);
    if (in.segments().find("Params"))
        return in.number("Params", set.field_of_view_rad);
    for (const Segment& segment : in.segments().all()) {
        if (const auto angle_rad = readNumber(segment.text)) {
            set.field_of_view_rad = *angle_rad;
            return;
        }
    }
    in.refuse(in.segments().line(), "SET of a camera's zoom needs Params");
}

} // namespace usar::protocol
