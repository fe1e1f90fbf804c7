// Reads any message struct that describes itself (core/protocol/schema.h).
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/protocol/readers/line_reading.h"
#include "core/protocol/refill.h"
#include "core/protocol/schema.h"

namespace usar::protocol {

/// The segments of a line, or of one group, in order.
using Pairs = std::span<const KeyedText>;

/// True for the types of members that must be on the line; members of other types may be missing.
template <class Member>
inline constexpr bool is_required = std::is_same_v<Member, double> || std::is_same_v<Member, long long> ||
                                    std::is_same_v<Member, Vec3> || std::is_same_v<Member, Pose>;

/// The result of reading the items of one struct. A line without any item carries no data; if some items are there but
/// a required one is missing or damaged, the line stays generic.
struct ItemsFound {
    bool any = false;
    /// An item is on the line, but its value cannot be read; an error has been reported.
    bool damaged = false;
    std::string_view missing{}; ///< key of a required item that is not on the line; empty if there is none

    /// True if the struct is complete enough to be passed on.
    bool usable() const { return any && !damaged && missing.empty(); }
};

/// Reads one item; clears the member if the item is not among `pairs`.
template <class Owner, class Member>
void readItem(LineReading& line, Pairs pairs, Owner& owner, const Item<Owner, Member>& item, ItemsFound& found) {
    Member& member = owner.*item.member;
    const KeyedText* const pair = findPair(pairs, item.key, item.other_key);
    if (pair) {
        found.any = true;
        found.damaged |= !take(line, pair->value, member, item.crossing);
        return;
    }
    clear(member);
    if (is_required<Member>)
        found.missing = item.key;
}

/// Reads a pose, which is damaged if only one of its two segments is there.
/// Rotation is another spelling of Orientation. A pose that cannot be read becomes the zero pose.
template <class Owner>
void readItem(LineReading& line, Pairs pairs, Owner& owner, const PoseItem<Owner>& item, ItemsFound& found) {
    const KeyedText* const location = findPair(pairs, "Location");
    const KeyedText* const orientation = findPair(pairs, "Orientation", "Rotation");
    if (!location && !orientation) {
        found.missing = "Location";
        return;
    }
    found.any = true;
    if (!location || !orientation) {
        found.damaged = true;
        line.error(line.segments().line(), "a pose needs Location and Orientation");
        return;
    }
    const std::optional<Pose> pose = line.pose(location->value, orientation->value);
    found.damaged |= !pose;
    owner.*item.member = pose.value_or(Pose{});
}

/// Reads all items of one struct. Reports an error if only some of the required ones are there.
/// Segments that no item describes are ignored here.
template <class Owner>
ItemsFound readItems(LineReading& line, Pairs pairs, Owner& owner) {
    ItemsFound found;
    forEachItem<Owner>([&](const auto& item) { readItem(line, pairs, owner, item, found); });
    if (found.any && !found.damaged && !found.missing.empty())
        line.error(line.segments().line(), std::string(found.missing) + " is missing");
    return found;
}

/// Reads all groups in `pairs`, which begins with the first opening key, or with the values of a group that has no
/// opening key. Groups without values are left out. False if a group is damaged.
template <class Owner, class Element>
bool readGroups(LineReading& line, Pairs pairs, Owner& owner, const Groups<Owner, Element>& groups) {
    Refill<Element> elements(owner.*groups.member);
    const auto opens = [&groups](const KeyedText& pair) {
        return findPair({&pair, 1}, groups.opening_key, groups.other_key) != nullptr;
    };
    bool good = true;
    while (!pairs.empty()) {
        const auto end = std::find_if(pairs.begin() + 1, pairs.end(), opens);
        const Pairs group = pairs.first(static_cast<std::size_t>(end - pairs.begin()));
        Element& element = elements.next();
        const ItemsFound found = readItems(line, group, element);
        if constexpr (requires { element.name; }) {
            if (opens(group.front()))
                element.name = group.front().value;
            else
                element.name.clear();
        }
        if (!found.usable())
            elements.drop();
        good &= !found.any || found.usable();
        pairs = pairs.subspan(group.size());
    }
    return good;
}

/// Fills all of `out`, which may hold an older reading. Returns false if the line must stay a GenericMessage: without a
/// diagnostic if it has no data (only Time, Type and Name), with one if it is damaged.
template <Described T>
bool readDescribed(LineReading& line, T& out) {
    const Pairs pairs = line.pairs(NamedGroups<T>);
    out.time = line.time();
    if constexpr (requires { out.name; })
        out.name = line.segments().value("Name");
    if constexpr (requires { out.type; })
        out.type = line.segments().value("Type");
    Pairs head = pairs;
    bool any = false;
    if constexpr (HasGroups<T>) {
        constexpr auto groups = T::groups();
        const KeyedText* const first = findPair(pairs, groups.opening_key, groups.other_key);
        head = pairs.first(first ? static_cast<std::size_t>(first - pairs.data()) : pairs.size());
        // A sensor without a name: its values follow no opening key.
        const bool nameless = NamedGroups<T> && !first;
        if (!readGroups(line, nameless ? pairs : pairs.subspan(head.size()), out, groups))
            return false;
        any = !(out.*groups.member).empty();
    }
    if constexpr (HasItems<T>) {
        const ItemsFound found = readItems(line, head, out);
        any |= found.any;
        if (found.damaged || !found.missing.empty())
            return false;
    }
    return any;
}

} // namespace usar::protocol
