#include "core/campaign/statistics/sample.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace usar::campaign {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

} // namespace

std::vector<double> sortedCopy(std::span<const double> values) {
    std::vector<double> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

double mean(std::span<const double> values) {
    if (values.empty())
        return unknown;
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double median(std::span<const double> values) {
    return quantileOfSorted(sortedCopy(values), 0.5);
}

double quantileOfSorted(std::span<const double> sorted, double share) {
    if (sorted.empty())
        return unknown;
    const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], place - static_cast<double>(below));
}

double variance(std::span<const double> values) {
    if (values.size() < 2)
        return unknown;
    const double center = mean(values);
    double squares = 0.0;
    for (const double value : values)
        squares += (value - center) * (value - center);
    return squares / static_cast<double>(values.size() - 1);
}

std::size_t trimmedAtEachEnd(std::size_t count, double share) {
    return static_cast<std::size_t>(share * static_cast<double>(count));
}

double trimmedMean(std::span<const double> values, double share) {
    const std::vector<double> sorted = sortedCopy(values);
    const std::size_t cut = trimmedAtEachEnd(sorted.size(), share);
    return mean(std::span(sorted).subspan(cut, sorted.size() - 2 * cut));
}

double restrictedMean(std::span<const double> times, double limit) {
    std::vector<double> restricted(times.begin(), times.end());
    for (double& time : restricted)
        time = std::min(time, limit);
    return mean(restricted);
}

} // namespace usar::campaign
