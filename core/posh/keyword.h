// The words with a meaning of their own, in any case; where only a name can stand they are names.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/posh/plan.h"

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

Keyword keywordOf(std::string_view word);

/// DC, RDC, SDC or SRDC.
std::optional<CollectionKind> collectionKind(Keyword keyword);

/// Of a time limit or a frequency.
std::optional<Unit> unitOf(Keyword keyword);

/// Hours, minutes, seconds and none.
bool isTimeUnit(Unit unit);

/// `nil`, `true` and `false`.
constexpr bool isLiteral(Keyword keyword) {
    return keyword == Keyword::Nil || keyword == Keyword::True || keyword == Keyword::False;
}

/// C, AP, AD, a collection or documentation.
constexpr bool beginsForm(Keyword keyword) {
    return keyword >= Keyword::C && keyword <= Keyword::Documentation;
}

} // namespace usar::posh
