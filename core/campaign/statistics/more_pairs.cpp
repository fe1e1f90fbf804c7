#include "core/campaign/statistics/more_pairs.h"

#include <cmath>

namespace usar::campaign {

namespace {

constexpr double most_pairs = 1e6;

} // namespace

std::optional<std::size_t> morePairsToDecide(const MeasuredDifference& measured, double margin) {
    const auto& [low, high] = measured.interval;
    if (low > margin || high < -margin || (low >= -margin && high <= margin))
        return 0;
    if (measured.pairs == 0)
        return std::nullopt;
    const double pairs = static_cast<double>(measured.pairs);
    const double shrink = measured.interval.halfWidth() / std::abs(std::abs(measured.estimate) - margin);
    const double needed = std::ceil(pairs * shrink * shrink);
    if (!(needed <= most_pairs)) // also where it is not a number
        return std::nullopt;
    // An interval that lies askew may reach over the margin although it is narrow enough.
    return needed > pairs ? static_cast<std::size_t>(needed - pairs) : 1;
}

} // namespace usar::campaign
