// Lists the values of any message struct that describes itself (core/protocol/schema.h).
#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/protocol/field_list.h"
#include "core/protocol/schema.h"

namespace usar::protocol {

/// Adds one member of a message to `fields` under the name `field`. Absent optionals and empty texts add nothing.
struct ValueLister {
    FieldList& fields;
    /// Views of the message's description, which is constant.
    std::string_view field;
    std::string_view unit;
    /// True if a vector holds roll, pitch and yaw, whose parts have names of their own.
    bool is_angles;

    /// Numbers are listed in the unit of the message struct, not of the wire.
    void operator()(double value) const { fields.number(field, value, unit); }
    void operator()(long long value) const { fields.number(field, static_cast<double>(value), unit); }
    void operator()(bool value) const { fields.flag(field, value); }
    /// A word without a value is listed as a flag, even if it is absent.
    void operator()(Present value) const { fields.flag(field, value == Present::Yes); }
    void operator()(const std::string& value) const {
        if (!value.empty())
            fields.text(field, value);
    }
    /// Listed as a number of seconds.
    void operator()(Seconds value) const { fields.number(field, value.count(), unit); }
    void operator()(const Vec3& value) const { fields.vector(field, value, unit, is_angles); }
    /// Lists x, y and yaw only, because only ground robots send a pose in a single segment.
    void operator()(const Pose& value) const {
        fields.number("x", value.position_m.x(), "m");
        fields.number("y", value.position_m.y(), "m");
        fields.number("yaw", value.yaw_rad, "rad");
    }
    void operator()(const std::vector<double>& values) const { fields.values(field, values, unit); }
    /// An absent value has no entry, as opposed to 0.
    template <class T>
    void operator()(const std::optional<T>& value) const {
        if (value)
            (*this)(*value);
    }
};

/// Adds one item under the name and unit in its description.
/// The entry's source and item are those that `fields` has at the time.
template <class Owner, class Member>
void listItem(FieldList& fields, const Owner& owner, const Item<Owner, Member>& item) {
    ValueLister{fields, item.field, item.unit, item.crossing == Crossing::Angles}(owner.*item.member);
}

/// Adds all six values of a pose.
template <class Owner>
void listItem(FieldList& fields, const Owner& owner, const PoseItem<Owner>& item) {
    fields.pose(owner.*item.member);
}

/// Adds all items of one message or group, without its groups.
template <class Owner>
void listItems(FieldList& fields, const Owner& owner) {
    forEachItem<Owner>([&](const auto& item) { listItem(fields, owner, item); });
}

/// The number that opened an element's group on the wire, or, if groups are opened by something that does not identify
/// them, `number`, the element's position from 1.
template <class Element>
std::string openingValue(const Element& element, std::size_t number) {
    constexpr auto first = std::get<0>(Element::items());
    if constexpr (std::is_same_v<std::decay_t<decltype(element.*first.member)>, long long>)
        return std::to_string(element.*first.member);
    else
        return std::to_string(number);
}

/// Adds all values of a message. The caller has set `fields.source`; each group becomes an item of its own: "F1", or
/// "CameraPanTilt Link 1".
template <Described T>
void listDescribed(FieldList& fields, const T& message) {
    if constexpr (requires { message.name; })
        fields.item = message.name;
    listItems(fields, message);
    if constexpr (HasGroups<T>) {
        constexpr auto groups = T::groups();
        const std::string name = fields.item;
        std::size_t number = 0;
        for (const auto& element : message.*groups.member) {
            ++number;
            if constexpr (requires { element.name; })
                fields.item = element.name;
            else
                fields.item = (name.empty() ? "" : name + " ") + std::string(groups.opening_key) + " " +
                              openingValue(element, number);
            listItems(fields, element);
        }
        fields.item = name;
    }
}

} // namespace usar::protocol
