// Changes a piece of a plan's text into another with as few bytes as possible.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/posh/token.h"

namespace usar::posh {

/// Bytes [begin, end) of a text are replaced.
struct Splice {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::string text;
};

/// What to replace in bytes [begin, end) of `text`, so that its words become those of `wanted`: what lies between the
/// words that both begin and end with. `tokens` are those of the whole text. Nothing where a comment would be lost.
std::optional<Splice> spliceTokens(std::string_view text, const TokenList& tokens, std::size_t begin, std::size_t end,
                                   std::string_view wanted);

/// Bytes [begin, end) of the text with the splices inside of them, which must be in order and apart.
std::string spliced(std::string_view text, std::size_t begin, std::size_t end, const std::vector<Splice>& splices);

} // namespace usar::posh
