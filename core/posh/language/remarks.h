// Assigns the comments and blank lines of a text to the parts of the plan that they belong to.
#pragma once

#include <cstddef>
#include <string_view>

#include "core/posh/language/token.h"
#include "core/posh/model/plan.h"

namespace usar::posh {

/// Fills the remarks of all parts of `plan`, which was read from `text`. A comment on a line of its own belongs to the
/// part that begins next, and one after other text to the part that began last. A comment inside a drive, an element,
/// or a form without levels belongs to that part. Comments after `closing`, the byte offset of the plan's closing
/// parenthesis, belong to the plan.
void attachRemarks(std::string_view text, const TokenList& tokens, std::size_t closing, Plan& plan);

} // namespace usar::posh
