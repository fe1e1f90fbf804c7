// Formats values as traces and reports print them.
#pragma once

#include <string>
#include <string_view>

#include "core/posh/model/plan.h"

namespace usar::posh {

/// Appends nil, true, 5, 2.0 (whole floats keep one decimal), "text" (quoted as in JSON) or 'symbol.
void appendValue(std::string& out, const Value& value);
std::string toText(const Value& value);
/// Appends the text in quotes, escaped as in JSON; characters beyond ASCII are not escaped.
void appendQuoted(std::string& out, std::string_view text);

} // namespace usar::posh
