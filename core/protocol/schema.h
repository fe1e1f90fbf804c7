// How a container lies on the wire, said once: reading, writing, listing of values and filing by name are made from it.
//
// A container describes itself by two static functions: `items()`, a tuple of its values, and, where values come in
// groups that repeat, `groups()`. One that is neither has functions of its own instead (see readers/described.h).
#pragma once

#include <string_view>
#include <tuple>
#include <vector>

#include "core/base/geometry.h"

namespace usar::protocol {

/// What must change between the wire's frame and ours. Vector: y and z change sign. Angles: roll, pitch, yaw; pitch and
/// yaw change sign. Turn: one angle, rate or sideways value changes sign. Planar: x, y, yaw of a pose.
enum class Crossing { None, Vector, Angles, Turn, Planar };

/// Unreal rounds where it prints a bare float or a vector whole, and cuts where its formatter prints four decimals
/// (usarsim-protocol 1.7).
enum class Decimals { TwoRounded, FourCut };

/// One segment and the member that holds it. `field` is the value's name in lists and plots, `unit` its unit there.
/// `other_key` is what other versions call it.
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

template <class Owner, class Member>
constexpr Item<Owner, Member> item(std::string_view key, Member Owner::*member, std::string_view field,
                                   std::string_view unit = {}, Crossing crossing = Crossing::None,
                                   Decimals decimals = Decimals::FourCut, std::string_view other_key = {}) {
    return {key, member, field, unit, crossing, decimals, other_key};
}

/// A pose in two segments, Location and Orientation, printed whole. UT2004 gives some angles in [0, 2 pi).
template <class Owner>
struct PoseItem {
    Pose Owner::*member;
    bool angles_positive = false;
};

template <class Owner>
constexpr PoseItem<Owner> pose(Pose Owner::*member, bool angles_positive = false) {
    return {member, angles_positive};
}

/// Values that repeat. Opened by Name they are sensors of one type, each with its own name: `{Name F1 Range 4.5}` in
/// UT2004, `{Name F1} {Range 4.5}` in UDK. Opened by another key they are what one sensor tells of several things.
template <class Owner, class Element>
struct Groups {
    std::string_view opening_key;
    std::vector<Element> Owner::*member;
    std::string_view other_key{};
};

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
/// Several sensors in one line, each with a name.
template <class T>
concept NamedGroups = HasGroups<T> && !requires(T value) {
    value.name;
};

/// Said by a word alone, `{Far}`, or not at all.
enum class Present : bool { No, Yes };

/// The type's first word in `wire_types`, "IR|Range", which is what we write.
constexpr std::string_view firstType(std::string_view wire_types) {
    return wire_types.substr(0, wire_types.find('|'));
}

/// The value of the Type segment that the sensor came or goes with.
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
/// What one sensor with a name tells: NamedRange of SonarReadings, an InsReading of itself.
template <class Sensor>
using ReadingOf = typename ReadingType<Sensor>::Type;

/// Calls `use(name, reading)` for each sensor that the message tells of: the groups of one that has named ones, else
/// the message itself.
template <SensorMessage Sensor, class Use>
void forEachReading(const Sensor& sensor, Use&& use) {
    if constexpr (NamedGroups<Sensor>) {
        for (const auto& reading : sensor.*Sensor::groups().member)
            use(reading.name, reading);
    } else {
        use(sensor.name, sensor);
    }
}

/// Calls `use(item)` for each item of T, in the order of the wire.
template <class T, class Use>
constexpr void forEachItem(Use&& use) {
    if constexpr (HasItems<T>)
        std::apply([&use](const auto&... one) { (use(one), ...); }, T::items());
}

/// The types of a list, to be unfolded.
template <class... Types>
struct TypeList {};

} // namespace usar::protocol
