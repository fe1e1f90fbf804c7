// Tells how well strips agree where they overlap, and compares two paths by that.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "core/mapping/strip_overlaps.h"

namespace usar::mapping {

/// Squares of the differences in height of overlaps, in sums by the two intervals between knots from which the looks
/// are. A difference counts at most 1 m. A plain value.
class StripResidual {
public:
    StripResidual() = default;
    explicit StripResidual(std::span<const Overlap> overlaps);

    std::size_t overlaps() const { return overlaps_; }
    /// Root mean square of all differences; absent without overlaps.
    std::optional<double> all_m() const;
    /// Root mean squares of both over what can be compared: with another path other looks meet in a cell, so only
    /// pairs of intervals that overlap with both paths count, each in proportion to the smaller number of its overlaps.
    /// Absent if there are none.
    static std::optional<std::pair<double, double>> compared_m(const StripResidual& a, const StripResidual& b);

private:
    struct Sum {
        double squares_m2 = 0.0;
        double overlaps = 0.0;
    };
    std::map<std::uint64_t, Sum> sums_;
    std::size_t overlaps_ = 0;
};

} // namespace usar::mapping
