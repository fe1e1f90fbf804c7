// The keywords of the plan language. Case does not matter. In a place where only a name is possible, a keyword is read
// as a name.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/posh/model/plan.h"

namespace usar::posh {

enum class Keyword : std::uint8_t {
    None, ///< an ordinary word
    C,
    Ap,
    Ad,
    Dc,
    Rdc,
    Sdc,
    Srdc,
    Documentation,
    Drives,
    Elements,
    Goal,
    Trigger,
    Vars,
    Nil,
    True,
    False,
    Hours,
    Minutes,
    Seconds,
    NoUnit, ///< `none`
    Hz,
    PerMinute,
    Ticks,
};

/// Returns Keyword::None for a word that is not a keyword.
Keyword keywordOf(std::string_view word);

/// Returns the kind for DC, RDC, SDC and SRDC, and nullopt for other keywords.
std::optional<CollectionKind> collectionKind(Keyword keyword);

/// Returns the unit of a time limit or a frequency, or nullopt for other keywords.
std::optional<Unit> unitOf(Keyword keyword);

/// Returns true for hours, minutes, seconds and none, which are units of time, and false for rates and ticks.
bool isTimeUnit(Unit unit);

/// Returns whether the keyword is a value: `nil`, `true` or `false`.
constexpr bool isLiteral(Keyword keyword) {
    return keyword == Keyword::Nil || keyword == Keyword::True || keyword == Keyword::False;
}

/// Returns whether the keyword begins a form: C, AP, AD, one of the collections, or documentation.
constexpr bool beginsForm(Keyword keyword) {
    return keyword >= Keyword::C && keyword <= Keyword::Documentation;
}

} // namespace usar::posh
