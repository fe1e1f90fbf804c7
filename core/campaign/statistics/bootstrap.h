// The interval of a trimmed mean by drawing the sample again and again from itself.
#pragma once

#include <cstdint>
#include <span>

#include "core/campaign/statistics/interval.h"

namespace usar::campaign {

struct Resampling {
    double confidence = 0.95;
    int resamples = 10'000;
    std::uint64_t seed = 1;
};

/// The bias-corrected and accelerated (BCa) bootstrap interval of trimmedMean(values, trimmed_share); formulas of Efron
/// and Tibshirani (1993), section 14.3, and for several groups as scipy's bootstrap has them for several samples.
/// `groups` names the group of each value, such as its mission; each group is resampled for itself, so that its weight
/// stays what it was. It may be empty: then all values are one group. Unbounded for fewer than two values; a single
/// point if all values are equal. The same seed gives the same draws on every machine. One draw of the whole sample
/// costs a few nanoseconds for each value.
Interval bcaInterval(std::span<const double> values, std::span<const int> groups, double trimmed_share,
                     const Resampling& resampling = {});

} // namespace usar::campaign
