// Replaces a form in a text by its edited version and changes as few bytes as possible.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/posh/language/layout_text.h"
#include "core/posh/language/token.h"
#include "core/posh/model/plan.h"

namespace usar::posh {

/// Returns the text of `chunk`, which holds the form `old`, changed so that it holds `wanted`. Both forms must be of
/// the same kind; `tokens` are those of the whole `text`. Returns nullopt if the form must be rewritten as a whole: its
/// own remarks changed, a comment is in the middle of what changes, or one of the two forms has no levels.
std::optional<std::string> spliceForm(std::string_view text, const TokenList& tokens, const Chunk& chunk,
                                      const Form& old, const Form& wanted);

} // namespace usar::posh
