#include "core/campaign/statistics/paired.h"

#include <cmath>
#include <limits>

#include "core/campaign/statistics/sample.h"

namespace usar::campaign {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

} // namespace

std::vector<double> differences(std::span<const double> baseline, std::span<const double> candidate) {
    std::vector<double> result(baseline.size());
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = candidate[i] - baseline[i];
    return result;
}

double correlation(std::span<const double> first, std::span<const double> second) {
    if (first.size() < 2)
        return undefined;
    const double first_mean = mean(first), second_mean = mean(second);
    double products = 0.0, first_squares = 0.0, second_squares = 0.0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        const double a = first[i] - first_mean, b = second[i] - second_mean;
        products += a * b;
        first_squares += a * a;
        second_squares += b * b;
    }
    return products / std::sqrt(first_squares * second_squares);
}

double varianceRatio(std::span<const double> baseline, std::span<const double> candidate) {
    return variance(differences(baseline, candidate)) / (variance(baseline) + variance(candidate));
}

double probabilityOfImprovement(std::span<const double> baseline, std::span<const double> candidate,
                                bool lower_is_better) {
    double wins = 0.0;
    for (const double difference : differences(baseline, candidate))
        wins += difference == 0.0 ? 0.5 : (difference < 0.0) == lower_is_better ? 1.0 : 0.0;
    return wins / static_cast<double>(baseline.size());
}

double geometricMeanOfRatios(std::span<const double> baseline, std::span<const double> candidate) {
    double logarithms = 0.0;
    for (std::size_t i = 0; i < baseline.size(); ++i) {
        if (baseline[i] <= 0.0 || candidate[i] <= 0.0)
            return undefined;
        logarithms += std::log(candidate[i] / baseline[i]);
    }
    return std::exp(logarithms / static_cast<double>(baseline.size()));
}

} // namespace usar::campaign
