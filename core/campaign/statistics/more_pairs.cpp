#include "core/campaign/statistics/more_pairs.h"

#include <algorithm>
#include <cmath>

#include "core/campaign/statistics/normal.h"

namespace usar::campaign {

namespace {

constexpr double most_pairs = 1e6;

double square(double value) {
    return value * value;
}

/// So many times the pairs bring the interval to one piece of the line; at most 1 if it lies on one now. Only the side
/// that reaches over the margin counts, because an interval may lie askew.
double timesForInterval(const MeasuredDifference& measured, double margin) {
    const auto& [low, high] = measured.interval;
    const double estimate = measured.estimate, below = estimate - low, above = high - estimate;
    if (low > margin || high < -margin)
        return 1.0;
    if (estimate > margin)
        return square(below / (estimate - margin));
    if (estimate < -margin)
        return square(above / (-margin - estimate));
    return std::max(square(below / (estimate + margin)), square(above / (margin - estimate)));
}

/// So many times the pairs make the test agree that there is a difference; equality asks for no test.
double timesForTest(const MeasuredDifference& measured, double margin) {
    if (std::abs(measured.estimate) <= margin || measured.p < measured.needed_p)
        return 1.0;
    return square(normalReach(1.0 - measured.needed_p) / normalReach(1.0 - measured.p));
}

/// As many pairs of each kind as `pairs` of all would have.
PairedCount scaled(const PairedCount& count, std::size_t pairs) {
    const double factor = static_cast<double>(pairs) / static_cast<double>(count.pairs());
    const auto part = [factor](std::size_t number) {
        return static_cast<std::size_t>(std::llround(factor * static_cast<double>(number)));
    };
    return {part(count.both), part(count.baseline_only), part(count.candidate_only), part(count.neither)};
}

} // namespace

std::optional<std::size_t> morePairsToDecide(const MeasuredDifference& measured, double margin) {
    const auto& [low, high] = measured.interval;
    const bool is_beyond = low > margin || high < -margin, is_within = low >= -margin && high <= margin;
    if (is_within || (is_beyond && measured.p < measured.needed_p))
        return 0;
    if (measured.pairs == 0)
        return std::nullopt;
    const double pairs = static_cast<double>(measured.pairs);
    const double needed =
        std::ceil(pairs * std::max(timesForInterval(measured, margin), timesForTest(measured, margin)));
    if (!(needed <= most_pairs)) // also where it is not a number
        return std::nullopt;
    return needed > pairs ? static_cast<std::size_t>(needed - pairs) : 1;
}

std::optional<std::size_t> morePairsToDecide(const PairedCount& count, double margin, double confidence,
                                             double needed_p) {
    const std::size_t now = count.pairs();
    if (now == 0)
        return std::nullopt;
    for (std::size_t pairs = now; pairs <= static_cast<std::size_t>(most_pairs);
         pairs += std::max<std::size_t>(1, pairs / 100)) {
        const PairedCount more = scaled(count, pairs);
        const auto [low, high] = rateDifference(more, confidence);
        const bool is_within = low >= -margin && high <= margin;
        if (is_within || ((low > margin || high < -margin) && mcNemar(more) < needed_p))
            return pairs - now;
    }
    return std::nullopt;
}

} // namespace usar::campaign
