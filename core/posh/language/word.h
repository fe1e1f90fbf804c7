// Classifies words: a number, a name, or neither.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "core/posh/language/token.h"
#include "core/posh/model/finding.h"

namespace usar::posh {

/// The kind of a word.
struct WordKind {
    TokenKind kind = TokenKind::Name;
    bool starts_with_digit = false;           ///< it is a name, but starts with a digit
    std::optional<Code> error = std::nullopt; ///< set exactly if the kind is Bad
    std::size_t bad = 0;                      ///< byte offset of the error in the word
};

/// Classifies a word that is not quoted and does not include a leading `$` or `'`. The result is Integer, Float, Name
/// or Bad.
WordKind classifyWord(std::string_view word);

/// Classifies the word after a `'`: a name, or an enumeration constant if it has dots. The result is Symbol or Bad.
WordKind classifySymbol(std::string_view word);

} // namespace usar::posh
