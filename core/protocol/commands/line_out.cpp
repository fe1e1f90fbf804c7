#include "core/protocol/commands/line_out.h"

#include "core/protocol/commands/wire_degrees.h"

namespace usar::protocol {

void LineOut::degrees(std::string_view key, const std::optional<double>& angle_rad) {
    if (!angle_rad)
        return;
    open(key);
    appendDegrees(out_, finite(*angle_rad));
    close();
}

void LineOut::flippedDegrees(std::string_view key, const std::optional<double>& angle_rad) {
    if (angle_rad)
        degrees(key, acrossWire(*angle_rad));
}

void LineOut::vector(std::string_view key, const std::optional<Vec3>& value) {
    if (!value)
        return;
    open(key);
    add(*value);
    close();
}

void LineOut::pose(const Pose& pose) {
    const Pose on_wire = acrossWire(pose);
    vector("Location", on_wire.position_m);
    vector("Rotation", Vec3(on_wire.roll_rad, on_wire.pitch_rad, on_wire.yaw_rad));
}

void LineOut::start(const std::variant<Pose, Token>& start) {
    if (const Token* const name = std::get_if<Token>(&start))
        text("Start", *name);
    else
        pose(std::get<Pose>(start));
}

void LineOut::add(const Vec3& value) {
    add(value.x());
    out_ += ',';
    add(value.y());
    out_ += ',';
    add(value.z());
}

} // namespace usar::protocol
