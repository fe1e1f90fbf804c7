// Conversion between values and their spelling in a plan.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/posh/model/plan.h"

namespace usar::posh {

/// Resolves the escapes of a string. `between_quotes` must be the inside of a well-formed string; bytes that are not
/// valid UTF-8 become U+FFFD.
std::string unescaped(std::string_view between_quotes);

/// Returns the text in double quotes, with escapes where a string needs them.
std::string quoted(std::string_view text);

/// Returns nullopt if the number is too large for a double. `word` must be a token of kind Float or Integer.
std::optional<double> floatOf(std::string_view word);

/// Returns the value as a plan writes it: `nil`, `true`, `7`, `2.0`, `"text"`, `'red`. Reading it back gives the same
/// value. A symbol with dots and hyphens gets no quote; it can only be the operand of a sense.
std::string spelled(const Value& value);

} // namespace usar::posh
