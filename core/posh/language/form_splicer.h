// Replaces a form in a text by its edited version and changes as few bytes as possible; helpers for the layout.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/posh/language/token.h"
#include "core/posh/model/plan.h"

namespace usar::posh {

/// The bytes of a text that belong to one form or level: what precedes it, the part itself, and the rest of its last
/// line. All fields are byte offsets; ends are exclusive.
struct Chunk {
    std::size_t begin = 0;
    std::size_t body = 0; ///< start of the part itself
    std::size_t body_end = 0;
    std::size_t end = 0;

    /// Returns the bytes of the chunk; `text` must be the text that the offsets refer to.
    std::string_view of(std::string_view text) const { return text.substr(begin, end - begin); }
};

/// Returns the offset after the end of the line if only blanks and a comment follow `from` on it, otherwise `from`.
std::size_t lineRest(std::string_view text, std::size_t from);

/// Returns `words` with CRLF line ends if `text` has any, except in strings, where a line end is part of the value.
std::string withLineEnds(std::string_view text, std::string words);

/// Returns the text of `chunk`, which holds the form `old`, changed so that it holds `wanted`. Both forms must be of
/// the same kind; `tokens` are those of the whole `text`. Returns nullopt if the form must be rewritten as a whole: its
/// own remarks changed, a comment is in the middle of what changes, or one of the two forms has no levels.
std::optional<std::string> spliceForm(std::string_view text, const TokenList& tokens, const Chunk& chunk,
                                      const Form& old, const Form& wanted);

} // namespace usar::posh
