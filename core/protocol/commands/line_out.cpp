#include "core/protocol/commands/line_out.h"

#include "core/protocol/commands/wire_degrees.h"

namespace usar::protocol {

void LineOut::number(const Key& key, const std::optional<double>& value, NumberForm form) {
    if (!value && !form.or_zero)
        return;
    double on_wire = finite(form.turned ? acrossWire(value.value_or(0.0)) : value.value_or(0.0));
    if (form.scaled && normalized_)
        on_wire = std::clamp(on_wire, -100.0, 100.0);
    open(key);
    if (form.degrees)
        appendDegrees(out_, on_wire);
    else
        add(on_wire);
    close();
}

void LineOut::vector(const Key& key, const std::optional<Vec3>& value) {
    if (!value)
        return;
    open(key);
    add(*value);
    close();
}

void LineOut::pose(const Pose& pose) {
    const Pose on_wire = acrossWire(pose);
    vector(location_key, on_wire.position_m);
    vector(rotation_key, anglesOf(on_wire));
}

void LineOut::start(const Key& key, const std::variant<Pose, Token>& start, const std::optional<Pose>* fallback) {
    const Token* const name = std::get_if<Token>(&start);
    if (!name)
        return pose(std::get<Pose>(start));
    text(key, *name);
    if (fallback && *fallback)
        pose(**fallback);
}

void LineOut::sixNumbers(const Key& key, const Pose& pose) {
    const Pose on_wire = acrossWire(pose);
    open(key);
    add(on_wire.position_m);
    out_ += ',';
    add(anglesOf(on_wire));
    close();
}

void LineOut::goal(const Key& point_key, const Key& node_key, const std::variant<Vec2, Token>& goal) {
    if (const Token* const node = std::get_if<Token>(&goal))
        return text(node_key, *node);
    const Vec2& point_m = std::get<Vec2>(goal);
    const Vec3 on_wire = acrossWire(Vec3(point_m.x(), point_m.y(), 0.0));
    open(point_key);
    add(on_wire.x());
    out_ += ',';
    add(on_wire.y());
    close();
}

void LineOut::points(const Key& key, const std::vector<Vec3>& points) {
    open(key);
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i > 0)
            out_ += ';';
        add(acrossWire(points[i]));
    }
    close();
}

void LineOut::box(const Key& min_key, const Key& max_key, const std::optional<Box>& box) {
    if (!box)
        return;
    const Box on_wire = acrossWire(*box);
    vector(min_key, on_wire.min_m);
    vector(max_key, on_wire.max_m);
}

void LineOut::pace(const Key& speed_key, const Key& time_key, const std::variant<WaypointSpeed, Seconds>& pace) {
    if (const auto* const speed = std::get_if<WaypointSpeed>(&pace))
        number(speed_key, speed->speed_m_s);
    else
        number(time_key, std::get<Seconds>(pace));
}

void LineOut::valueAndSteer(const Key& key, double value, const std::optional<double>& steer_rad) {
    open(key);
    add(value);
    if (steer_rad) {
        out_ += ',';
        add(acrossWire(*steer_rad));
    }
    close();
}

void LineOut::tagAndText(const Key& key, const Token& tag, const Text& text) {
    open(key);
    out_.append(tag.text());
    if (!text.empty())
        out_.append(" ").append(text.text());
    close();
}

void LineOut::add(const Vec3& value) {
    add(value.x());
    out_ += ',';
    add(value.y());
    out_ += ',';
    add(value.z());
}

} // namespace usar::protocol
