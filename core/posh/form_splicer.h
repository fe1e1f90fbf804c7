// Puts an edited form in the place of the old one in a text, with as few other bytes as possible.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/posh/layout_text.h"
#include "core/posh/plan.h"
#include "core/posh/token.h"

namespace usar::posh {

/// The chunk of the old form with the wanted one, which is of the same kind. Nothing where it must be written anew: its
/// own remarks changed, a comment stands where words change, or nothing is left of its levels.
std::optional<std::string> spliceForm(std::string_view text, const TokenList& tokens, const Chunk& chunk,
                                      const Form& old, const Form& wanted);

} // namespace usar::posh
