// Substring search that ignores the case of ASCII letters; used to filter long logs.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace usar::widgets {

/// Searches for one needle with Horspool's algorithm; bytes beyond ASCII must match exactly. An empty needle is found
/// in every text.
class CaselessFinder {
public:
    explicit CaselessFinder(std::string_view needle);

    /// True if the needle occurs in `text`.
    bool isIn(std::string_view text) const { return placeIn(text) != std::string_view::npos; }
    /// Returns the offset, in bytes, of the first occurrence, or npos.
    std::size_t placeIn(std::string_view text) const;
    bool empty() const { return needle_.empty(); }

private:
    std::string needle_;                   ///< in lower case
    std::array<std::size_t, 256> shift_{}; ///< by the byte at the end of the window, in either case
};

} // namespace usar::widgets
