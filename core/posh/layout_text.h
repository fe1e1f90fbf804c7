// Lines of a plan's text, as its writer takes them apart and puts them together.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace usar::posh {

/// One of several things in a row: what stands before it, itself, and the rest of its last line.
struct Chunk {
    std::size_t begin = 0;
    std::size_t body = 0;
    std::size_t body_end = 0;
    std::size_t end = 0;

    std::string_view of(std::string_view text) const { return text.substr(begin, end - begin); }
};

/// Behind the end of the line, if only blanks and a comment are left of it; else `from`.
std::size_t lineRest(std::string_view text, std::size_t from);

/// `words` with the line ends that `text` has; those within strings are part of their values.
std::string withLineEnds(std::string_view text, std::string words);

} // namespace usar::posh
