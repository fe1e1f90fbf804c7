// The wire format of a message struct, stated once; reading, writing, listing and filing by name are derived from it.
//
// A struct describes itself by two static functions: `items()`, a tuple of its values, and, if values come in groups
// that repeat, `groups()`. A struct that has neither provides its own read, write and list functions instead.
#pragma once

#include <string_view>
#include <tuple>
#include <vector>

#include "core/base/geometry.h"
#include "core/protocol/sensors/wire_types.h"

namespace usar::protocol {

/// How a value is converted between the wire's frame and ours. Vector: y and z change sign. Angles (roll, pitch, yaw):
/// pitch and yaw change sign. Turn (a single angle, rate or sideways value): the sign changes. Planar (x, y, yaw of a
/// pose): y and yaw change sign.
enum class Crossing { None, Vector, Angles, Turn, Planar };

/// Unreal rounds to two decimals when it prints a bare float or a whole vector, and truncates when its formatter prints
/// four decimals (protocol.md 1.7).
enum class Decimals { TwoRounded, FourCut };

/// One segment and the member that holds its value. `key` is its key on the wire, `other_key` the key in other versions
/// of servers, or empty. `field` is the value's name in lists and plots, `unit` its unit there.
template <class Owner, class Member>
struct Item {
    std::string_view key;
    Member Owner::*member;
    std::string_view field;
    std::string_view unit;
    Crossing crossing = Crossing::None;
    Decimals decimals = Decimals::FourCut;
    std::string_view other_key{};
};

/// Describes one value; without a unit it has none, and without a crossing it is the same on the wire and here.
template <class Owner, class Member>
constexpr Item<Owner, Member> item(std::string_view key, Member Owner::*member, std::string_view field,
                                   std::string_view unit = {}, Crossing crossing = Crossing::None,
                                   Decimals decimals = Decimals::FourCut, std::string_view other_key = {}) {
    return {key, member, field, unit, crossing, decimals, other_key};
}

/// A pose in two segments, Location and Orientation, with two decimals each. `angles_positive` writes the angles in [0,
/// 2 pi), as UT2004 does for some sensors.
template <class Owner>
struct PoseItem {
    Pose Owner::*member;
    bool angles_positive = false;
};

/// Describes a pose; it has no key of its own.
template <class Owner>
constexpr PoseItem<Owner> pose(Pose Owner::*member, bool angles_positive = false) {
    return {member, angles_positive};
}

/// Groups of values that repeat. Each segment with `opening_key` begins a new element. Groups opened by Name are
/// sensors of one type, each with its own name: `{Name F1 Range 4.5}` in UT2004, `{Name F1} {Range 4.5}` in UDK. Groups
/// opened by another key are several things that one sensor reports.
template <class Owner, class Element>
struct Groups {
    std::string_view opening_key;
    std::vector<Element> Owner::*member;
    std::string_view other_key{};
};

/// Describes the groups of a message; `member` holds one element for each group, in wire order.
template <class Owner, class Element>
constexpr Groups<Owner, Element> groups(std::string_view opening_key, std::vector<Element> Owner::*member,
                                        std::string_view other_key = {}) {
    return {opening_key, member, other_key};
}

template <class T>
concept HasItems = requires {
    T::items();
};
template <class T>
concept HasGroups = requires {
    T::groups();
};
template <class T>
concept Described = HasItems<T> || HasGroups<T>;
/// A message about several sensors, each with its own name.
template <class T>
concept NamedGroups = HasGroups<T> && !requires(T value) {
    value.name;
};

/// A flag that is sent as a word without a value, `{Far}`, or not at all.
enum class Present : bool { No, Yes };

/// The value of the Type segment with which the sensor's message was received or will be sent.
template <class Sensor>
constexpr std::string_view wireTypeOf(const Sensor& sensor) {
    if constexpr (requires { sensor.type; })
        return sensor.type;
    else
        return firstType(Sensor::wire_types);
}

template <class T>
concept SensorMessage = requires {
    T::wire_types;
};

template <class Sensor>
struct ReadingType {
    using Type = Sensor;
};
template <class Owner, class Element>
Element elementOf(Groups<Owner, Element>);
template <NamedGroups Sensor>
struct ReadingType<Sensor> {
    using Type = decltype(elementOf(Sensor::groups()));
};
/// The type that holds the reading of a single sensor: NamedRange for SonarReadings, InsReading for InsReading.
template <class Sensor>
using ReadingOf = typename ReadingType<Sensor>::Type;

/// Calls `use(name, reading)` for each sensor in the message: for its groups if they are named, else once for the
/// message itself.
template <SensorMessage Sensor, class Use>
void forEachReading(const Sensor& sensor, Use&& use) {
    if constexpr (NamedGroups<Sensor>) {
        for (const auto& reading : sensor.*Sensor::groups().member)
            use(reading.name, reading);
    } else {
        use(sensor.name, sensor);
    }
}

/// Calls `use(item)` for each item of T in wire order; never if T has no items.
template <class T, class Use>
constexpr void forEachItem(Use&& use) {
    if constexpr (HasItems<T>)
        std::apply([&use](const auto&... one) { (use(one), ...); }, T::items());
}

/// A list of types as a value, from which templates deduce the pack.
template <class... Types>
struct TypeList {};

} // namespace usar::protocol
