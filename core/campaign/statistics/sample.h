// Figures of one sample of numbers. Where a sample is called sorted, it is in ascending order.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace usar::campaign {

/// A copy in ascending order.
std::vector<double> sortedCopy(std::span<const double> values);

/// Not a number without values, as are all functions here.
double mean(std::span<const double> values);

/// The middle value, or the mean of the two in the middle.
double median(std::span<const double> values);

/// The value below which a share of the sorted sample lies; between two values in proportion, as numpy does by default.
double quantileOfSorted(std::span<const double> sorted, double share);

/// The mean of squared distances from the mean, with n - 1; not a number for fewer than two values.
double variance(std::span<const double> values);

/// How many values a trimmed mean of `count` values leaves out at each end: a share, rounded down.
std::size_t trimmedAtEachEnd(std::size_t count, double share);

/// The mean without a share of the values at each end, as scipy's trim_mean has it. With a share of 0.25 it is the
/// interquartile mean: as robust as a median nearly, and nearly as sharp as a mean (Agarwal et al. 2021). With 0 it is
/// the mean.
double trimmedMean(std::span<const double> values, double share);

/// The share that makes a trimmed mean the interquartile mean.
inline constexpr double interquartile = 0.25;

/// The mean time up to a limit, in the unit of `times`: what took longer, or did not end, counts the limit. An infinite
/// time is one that did not end.
double restrictedMean(std::span<const double> times, double limit);

} // namespace usar::campaign
