// Helpers for the code that edits the text of a plan and keeps its layout.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

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

} // namespace usar::posh
