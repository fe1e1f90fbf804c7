// Figures of two samples whose values belong together in pairs: the i-th of one was measured under the same conditions
// as the i-th of the other. Both samples have the same size.
#pragma once

#include <span>
#include <vector>

namespace usar::campaign {

/// The candidate's value minus the baseline's, for each pair.
std::vector<double> differences(std::span<const double> baseline, std::span<const double> candidate);

/// Pearson's correlation of the pairs, from -1 to 1: how much of a run is due to its seed. Not a number if one of the
/// samples has no spread, or for fewer than two pairs.
double correlation(std::span<const double> first, std::span<const double> second);

/// The variance of the difference of paired runs over that of runs that share no seed: 0.1 says that without pairing
/// ten times as many runs would be needed. Not a number if there is no spread at all.
double varianceRatio(std::span<const double> baseline, std::span<const double> candidate);

/// The share of pairs in which the candidate is better; equal ones count half. Not a number without pairs.
double probabilityOfImprovement(std::span<const double> baseline, std::span<const double> candidate,
                                bool lower_is_better);

/// The geometric mean of candidate over baseline: 0.5 says half as much, whatever the size of the pair's mission. Not a
/// number if there is no pair or if a value is not positive.
double geometricMeanOfRatios(std::span<const double> baseline, std::span<const double> candidate);

} // namespace usar::campaign
