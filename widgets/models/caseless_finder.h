// Finds a text in many others whatever the case of ASCII letters: the filter of long logs.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace usar::widgets {

/// Horspool's search; bytes beyond ASCII must match exactly. An empty needle is in every text.
class CaselessFinder {
public:
    explicit CaselessFinder(std::string_view needle);

    bool isIn(std::string_view text) const { return placeIn(text) != std::string_view::npos; }
    /// Where the first one begins; npos where there is none.
    std::size_t placeIn(std::string_view text) const;
    bool empty() const { return needle_.empty(); }

private:
    std::string needle_;                   ///< lower case
    std::array<std::size_t, 256> shift_{}; ///< by the byte under the needle's end, either case
};

} // namespace usar::widgets
