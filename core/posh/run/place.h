// The places of a compiled plan, by which traces, breakpoints and views name its parts.
#pragma once

#include <cstdint>
#include <limits>

#include "core/posh/model/call.h"

namespace usar::posh {

/// A position in one of a program's arrays; `nowhere` stands for none.
using Index = std::uint32_t;
constexpr Index nowhere = std::numeric_limits<Index>::max();

/// A half-open range of indices.
struct Range {
    Index first = 0;
    Index end = 0; ///< one past the last
    bool empty() const { return first == end; }
    bool contains(Index index) const { return index >= first && index < end; }
    bool operator==(const Range&) const = default;
};

enum class PlaceKind : std::uint8_t { Collection, Drive, Competence, Pattern, Adopt, Element, Act, SenseStep, Sense };

/// A node of the expanded plan. Traces, breakpoints and views refer to it by its index in Program::places. A form that
/// is reached in two ways has two places.
struct Place {
    PlaceKind kind = PlaceKind::Collection;
    Index parent = nowhere; ///< index in Program::places; `nowhere` for the collection
    Index name = 0;         ///< index in Program::names
    Index item = 0;         ///< index in the array of its kind: drives, forms, elements, acts or tests
    Index position = 0;     ///< the last number of its path
    Index reference = 0;    ///< for a competence, pattern or adopt: the number after "A:" before it in its path
    Spot at{};              ///< place of its name in the text
};

} // namespace usar::posh
