// Gives the comments and blank lines of a text to the parts of the plan they belong to.
#pragma once

#include <cstddef>
#include <string_view>

#include "core/posh/plan.h"
#include "core/posh/token.h"

namespace usar::posh {

/// A comment on a line of its own belongs to what begins next, one behind something to what began last; inside of a
/// drive or an element, and of any form that is written in one piece, it belongs to that. From `closing` on, where the
/// plan ends, comments belong to the plan.
void attachRemarks(std::string_view text, const TokenList& tokens, std::size_t closing, Plan& plan);

} // namespace usar::posh
