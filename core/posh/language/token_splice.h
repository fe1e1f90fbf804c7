// Small changes of a plan's text.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/posh/language/token.h"

namespace usar::posh {

/// A replacement of the bytes [begin, end) of a text by `text`.
struct Splice {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::string text;
};

/// Returns the smallest replacement after which bytes [begin, end) of `text` have the same tokens as `wanted`; the
/// tokens that both have at their beginning and end stay. `tokens` are those of the whole text. Returns nullopt if a
/// comment would be lost, or if not even the first and the last token agree.
std::optional<Splice> spliceTokens(std::string_view text, const TokenList& tokens, std::size_t begin, std::size_t end,
                                   std::string_view wanted);

/// Returns bytes [begin, end) of the text after the splices. These must be in order and must not overlap; splices that
/// are not inside the range are ignored.
std::string spliced(std::string_view text, std::size_t begin, std::size_t end, const std::vector<Splice>& splices);

} // namespace usar::posh
