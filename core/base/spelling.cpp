#include "core/base/spelling.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace usar {

std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = std::exchange(row[j], std::min({replaced, row[j] + 1, row[j - 1] + 1}));
        }
    }
    return row.back();
}

std::string nearestWord(std::string_view word, const std::vector<std::string>& known) {
    const auto nearest =
        std::ranges::min_element(known, {}, [word](const std::string& other) { return editDistance(word, other); });
    return nearest == known.end() ? std::string() : *nearest;
}

} // namespace usar
