// Strong types for the numbers by which things are identified: a node of a plan, a breakpoint, a body.
#pragma once

#include <compare>
#include <cstddef>
#include <functional>

namespace usar {

/// The number of one thing among its kind. Each `Tag` makes a type of its own, so that the id of a breakpoint cannot be
/// passed where a node is meant. `None` is the number that no thing has, which a new id holds; its type is that of the
/// numbers. A struct that needs only to be named serves as the tag: `using BodyId = Id<struct BodyTag, 0U>;`
template <class Tag, auto None = -1>
struct Id {
    decltype(None) value = None;

    constexpr bool valid() const { return value != None; }
    /// Place in a vector that holds the things in the order of their numbers; meaningless for none.
    constexpr std::size_t index() const { return static_cast<std::size_t>(value); }
    auto operator<=>(const Id&) const = default;
};

} // namespace usar

template <class Tag, auto None>
struct std::hash<usar::Id<Tag, None>> {
    std::size_t operator()(const usar::Id<Tag, None>& id) const noexcept {
        return std::hash<decltype(None)>{}(id.value);
    }
};
