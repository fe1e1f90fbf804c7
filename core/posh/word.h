// What a run of characters is: a number, a name, or neither.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "core/posh/finding.h"
#include "core/posh/token.h"

namespace usar::posh {

/// `bad` is where in the word the error sits.
struct WordKind {
    TokenKind kind = TokenKind::Name;
    bool starts_with_digit = false; ///< a name that does
    std::optional<Code> error = std::nullopt;
    std::size_t bad = 0;
};

/// A word outside quotes and without `$` or `'`.
WordKind classifyWord(std::string_view word);

/// What stands behind the `'`: a name, or an enumeration constant where it has dots.
WordKind classifySymbol(std::string_view word);

} // namespace usar::posh
