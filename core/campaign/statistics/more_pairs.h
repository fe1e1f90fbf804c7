// How many more pairs would decide a comparison.
#pragma once

#include <cstddef>
#include <optional>

#include "core/campaign/statistics/interval.h"
#include "core/campaign/statistics/proportion.h"

namespace usar::campaign {

/// What is known of a difference from a number of pairs.
struct MeasuredDifference {
    std::size_t pairs = 0;
    double estimate = 0.0;
    Interval interval;
    double p = 0.0;           ///< by the test beside the interval, before any adjustment
    double needed_p = 1.0;    ///< A difference beyond the margin needs a p below this.
    double confidence = 0.95; ///< that of the interval
};

/// How many pairs must be added until it is as likely as not that the interval lies wholly between plus and minus
/// `margin`, or wholly beyond one of them while the test agrees, if each side of the interval shrinks with the root of
/// the number of pairs, and the test's deviate grows with it. An estimate beyond the margin is expected to stay. One
/// within it is expected to be nearer to zero, by as much as its error alone puts it away from there, because equal
/// variants are never measured equal. 0 if it is decided now. Nothing where a million pairs would not do, because the
/// estimate is too near to the margin, and where there is no pair or no width is known.
std::optional<std::size_t> morePairsToDecide(const MeasuredDifference& measured, double margin);

/// The same for the difference of two rates, by the intervals of more pairs of the same kinds in the same shares: where
/// few or no pairs differ, they shrink faster than with the root.
std::optional<std::size_t> morePairsToDecide(const PairedCount& count, double margin, double confidence,
                                             double needed_p);

} // namespace usar::campaign
