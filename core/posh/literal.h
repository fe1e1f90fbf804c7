// Values as they are spelled, and spellings of values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/posh/plan.h"

namespace usar::posh {

/// What stands between the quotes of a well-formed string, with its escapes resolved; bytes that are no UTF-8 become
/// U+FFFD.
std::string unescaped(std::string_view between_quotes);

/// "…" with escapes for what a string cannot hold as it is.
std::string quoted(std::string_view text);

/// Nothing where no 64-bit integer holds it. `word` must be an INT.
std::optional<std::int64_t> integerOf(std::string_view word);
/// Nothing where no double holds it. `word` must be a FLOAT or INT.
std::optional<double> floatOf(std::string_view word);

/// As a plan writes it: `nil`, `true`, `7`, `2.0`, `"text"`, `'red`. Reads back to the same value. A symbol with dots
/// and hyphens, which only a sense can be compared with, has no quote.
std::string spelled(const Value& value);

} // namespace usar::posh
