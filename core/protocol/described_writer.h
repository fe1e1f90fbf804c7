// Writes any message struct that describes itself (core/protocol/schema.h), as a UT2004 server does.
#pragma once

#include <string>

#include "core/protocol/line_writer.h"
#include "core/protocol/schema.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

/// Roll, pitch and yaw in rad, in [0, 2 pi), as UT2004's ground truth and INS send them. The pose's angles are in (-pi,
/// pi].
inline Vec3 positiveAnglesOf(const Pose& pose) {
    return anglesOf(pose).unaryExpr([](double angle_rad) { return angle_rad < 0 ? angle_rad + 2 * pi : angle_rad; });
}

/// Appends the value of one segment to `line`, converted from our frame to the wire's. Optionals must hold a value.
/// The writer refers to the line and is made for one value.
struct ValueWriter {
    LineWriter& line;
    Crossing crossing;
    Decimals decimals;

    /// A turn changes its sign on the way to the wire; other numbers do not.
    void operator()(double value) const {
        line.number(crossing == Crossing::Turn ? acrossWire(value) : value, decimals);
    }
    /// A whole number has no decimals, whatever `decimals` says.
    void operator()(long long value) const { line.whole(value); }
    /// Unreal's spelling of a bool.
    void operator()(bool value) const { line.text(value ? "True" : "False"); }
    /// The key alone states it.
    void operator()(Present) const {}
    void operator()(const std::string& value) const { line.text(value); }
    /// Seconds with a fraction.
    void operator()(Seconds value) const { line.number(value.count(), decimals); }
    /// Angles and vectors have different signs on the wire; values that do not cross are written as they are.
    void operator()(const Vec3& value) const {
        if (crossing == Crossing::Angles)
            line.numbers(anglesOf(acrossWire(Pose{Vec3::Zero(), value.x(), value.y(), value.z()})), decimals);
        else
            line.numbers(crossing == Crossing::Vector ? acrossWire(value) : value, decimals);
    }
    /// A pose on the ground: x, y and yaw.
    void operator()(const Pose& value) const {
        const Pose on_wire = acrossWire(value);
        line.numbers(Vec3(on_wire.position_m.x(), on_wire.position_m.y(), on_wire.yaw_rad), decimals);
    }
    void operator()(const std::vector<double>& values) const { line.numbers(values, decimals); }
    template <class T>
    void operator()(const std::optional<T>& value) const {
        (*this)(*value);
    }
};

/// False if the member is absent or empty, so that no segment is written for it.
template <class Member>
bool isThere(const Member& member) {
    if constexpr (std::is_same_v<Member, Present>)
        return member == Present::Yes;
    else if constexpr (requires { member.has_value(); })
        return member.has_value();
    else if constexpr (requires { member.empty(); })
        return !member.empty();
    else
        return true;
}

/// Writes one item as a segment of its own, or, with `in_segment`, as one of several pairs of the open segment.
template <class Owner, class Member>
void writeItem(LineWriter& line, const Owner& owner, const Item<Owner, Member>& item, bool in_segment) {
    const Member& member = owner.*item.member;
    if (!isThere(member))
        return;
    line.text(in_segment ? " " : " {");
    line.text(item.key);
    if constexpr (!std::is_same_v<Member, Present>)
        line.text(" ");
    ValueWriter{line, item.crossing, item.decimals}(member);
    if (!in_segment)
        line.close();
}

/// Writes a pose as Location and Orientation.
template <class Owner>
void writeItem(LineWriter& line, const Owner& owner, const PoseItem<Owner>& item, bool) {
    const Pose on_wire = acrossWire(owner.*item.member);
    line.segment("Location", on_wire.position_m, Decimals::TwoRounded);
    line.segment("Orientation", item.angles_positive ? positiveAnglesOf(on_wire) : anglesOf(on_wire),
                 Decimals::TwoRounded);
}

/// Writes all items of one message or group, without its groups.
/// The order is that of the struct's description.
template <class Owner>
void writeItems(LineWriter& line, const Owner& owner, bool in_segment = false) {
    forEachItem<Owner>([&](const auto& item) { writeItem(line, owner, item, in_segment); });
}

/// Writes everything that follows the type word, Time and Type.
template <Described T>
void writeDescribed(LineWriter& line, const T& message) {
    if constexpr (requires { message.name; })
        if (!message.name.empty())
            line.segment("Name", message.name);
    writeItems(line, message);
    if constexpr (HasGroups<T>) {
        for (const auto& element : message.*T::groups().member) {
            if constexpr (requires { element.name; }) {
                line.open("Name");
                line.text(element.name);
                writeItems(line, element, true);
                line.close();
            } else {
                writeItems(line, element);
            }
        }
    }
}

} // namespace usar::protocol
