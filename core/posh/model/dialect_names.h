// Names, values and texts converted to what other dialects of POSH allow. Each function returns valid input unchanged.
#pragma once

#include <string>
#include <string_view>

#include "core/posh/model/plan.h"

namespace usar::posh {

/// Returns a name without dots and without a digit at the start.
std::string classicName(std::string_view name);
/// Returns a name without a digit at the start.
std::string yaposhName(std::string_view name);

/// Replaces hyphens in constants (symbols with dots) by underscores.
Value yaposhValue(const Value& value);
/// Converts everything but nil to numbers and symbols without dots: a boolean becomes 1 or 0, a text becomes a symbol,
/// and a constant becomes its last part.
Value classicValue(const Value& value);

/// Returns the text on one line, with double quotes, backslashes, ; and # replaced by similar characters.
std::string classicText(std::string_view text);

} // namespace usar::posh
