// Names, values and texts as other dialects allow them. Each function gives back what is fine as it is.
#pragma once

#include <string>
#include <string_view>

#include "core/posh/plan.h"

namespace usar::posh {

/// Without dots, and not starting with a digit.
std::string classicName(std::string_view name);
/// Not starting with a digit.
std::string yaposhName(std::string_view name);

/// Constants (symbols with dots) without hyphens.
Value yaposhValue(const Value& value);
/// Numbers and symbols without dots only: truth becomes 1 or 0, a text a symbol of its words, a constant its last part.
Value classicValue(const Value& value);

/// On one line, without quotes, backslashes, ; and #.
std::string classicText(std::string_view text);

} // namespace usar::posh
