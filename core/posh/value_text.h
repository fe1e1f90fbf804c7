// Values as traces and reports print them.
#pragma once

#include <string>
#include <string_view>

#include "core/posh/plan.h"

namespace usar::posh {

/// nil, true, 5, 2.0 (whole floats keep one decimal), "text" in JSON quotes, 'symbol.
void appendValue(std::string& out, const Value& value);
std::string toText(const Value& value);
/// With quotes, escaped as JSON asks; letters beyond ASCII stay as they are.
void appendQuoted(std::string& out, std::string_view text);

} // namespace usar::posh
