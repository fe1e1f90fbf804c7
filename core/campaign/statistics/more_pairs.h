// How many more pairs would decide a comparison.
#pragma once

#include <cstddef>
#include <optional>

#include "core/campaign/statistics/interval.h"

namespace usar::campaign {

/// What is known of a difference from a number of pairs.
struct MeasuredDifference {
    std::size_t pairs = 0;
    double estimate = 0.0;
    Interval interval;
};

/// How many pairs must be added until the interval lies wholly on one side of plus or minus `margin`, or wholly between
/// them, if the estimate stays and the width shrinks with the root of the number of pairs. 0 if it does so now. Nothing
/// where a million pairs would not do, because the estimate is too near to the margin, and where there is no pair
/// or no width is known.
std::optional<std::size_t> morePairsToDecide(const MeasuredDifference& measured, double margin);

} // namespace usar::campaign
