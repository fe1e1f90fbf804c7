#include "core/mapping/height_histogram.h"

#include <algorithm>
#include <cmath>

namespace usar::mapping {

void HeightHistogram::add(std::span<const float> heights_m) {
    const float extent_m = whole_.maximum_m - whole_.minimum_m;
    const float bins_per_m = extent_m > 0.0f ? float(bin_count) / extent_m : 0.0f;
    for (const float height_m : heights_m) {
        if (!std::isfinite(height_m))
            continue;
        const float bin = std::clamp((height_m - whole_.minimum_m) * bins_per_m, 0.0f, float(bin_count - 1));
        ++counts_[static_cast<std::size_t>(bin)];
        ++cells_;
    }
}

HeightRange HeightHistogram::trimmed() const {
    const std::uint64_t left_out = cells_ / 50; // 2 %
    std::size_t low = 0;
    std::size_t high = bin_count;
    for (std::uint64_t below = counts_[low]; below <= left_out && low + 1 < high; below += counts_[low])
        ++low;
    for (std::uint64_t above = counts_[high - 1]; above <= left_out && low + 1 < high; above += counts_[high - 1])
        --high;
    return cells_ == 0 ? whole_ : HeightRange{edge_m(low), edge_m(high)};
}

float HeightHistogram::edge_m(std::size_t bin) const {
    if (bin == bin_count)
        return whole_.maximum_m; // Exactly.
    return whole_.minimum_m + (whole_.maximum_m - whole_.minimum_m) * float(bin) / float(bin_count);
}

} // namespace usar::mapping
