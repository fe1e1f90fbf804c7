// How often each height occurs, to find a range that a few extreme cells do not stretch.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/mapping/height_map.h"

namespace usar::mapping {

/// Counts cells in equal steps of height. A plain value.
class HeightHistogram {
public:
    static constexpr std::size_t bin_count = 1024;

    /// `whole` includes all heights; those outside of it count as its nearest end.
    explicit HeightHistogram(const HeightRange& whole) : whole_(whole) {}

    /// Counts these heights; what is not finite is none.
    void add(std::span<const float> heights_m);
    /// The range without the lowest 2 % and the highest 2 % of the cells, to within one step; the whole range if
    /// nothing was counted.
    HeightRange trimmed() const;

private:
    /// Height of the lower edge of a bin; that of `bin_count` is the upper end.
    float edge_m(std::size_t bin) const;

    HeightRange whole_;
    std::array<std::uint64_t, bin_count> counts_{};
    std::uint64_t cells_ = 0;
};

} // namespace usar::mapping
