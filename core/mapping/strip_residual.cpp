#include "core/mapping/strip_residual.h"

#include <algorithm>
#include <cmath>

namespace usar::mapping {

namespace {

constexpr double most_counted_m = 1.0;

} // namespace

StripResidual::StripResidual(std::span<const Overlap> overlaps) : overlaps_(overlaps.size()) {
    for (const Overlap& overlap : overlaps) {
        Sum& sum = sums_[intervalsOf(overlap)];
        const double counted_m = std::min(std::abs(double(overlap.difference_m)), most_counted_m);
        sum.squares_m2 += counted_m * counted_m;
        sum.overlaps += 1.0;
    }
}

std::optional<double> StripResidual::all_m() const {
    if (overlaps_ == 0)
        return std::nullopt;
    double squares_m2 = 0.0;
    for (const auto& [intervals, sum] : sums_)
        squares_m2 += sum.squares_m2;
    return std::sqrt(squares_m2 / double(overlaps_));
}

std::optional<std::pair<double, double>> StripResidual::compared_m(const StripResidual& a, const StripResidual& b) {
    double weights = 0.0, a_m2 = 0.0, b_m2 = 0.0;
    for (const auto& [intervals, of_a] : a.sums_) {
        const auto found = b.sums_.find(intervals);
        if (found == b.sums_.end())
            continue;
        const Sum& of_b = found->second;
        const double weight = std::min(of_a.overlaps, of_b.overlaps);
        weights += weight;
        a_m2 += weight * of_a.squares_m2 / of_a.overlaps;
        b_m2 += weight * of_b.squares_m2 / of_b.overlaps;
    }
    if (!(weights > 0.0))
        return std::nullopt;
    return std::pair(std::sqrt(a_m2 / weights), std::sqrt(b_m2 / weights));
}

} // namespace usar::mapping
