#include "core/campaign/statistics/more_pairs.h"

#include <algorithm>
#include <cmath>

#include "core/campaign/statistics/normal.h"

namespace usar::campaign {

namespace {

constexpr double most_pairs = 1e6;
constexpr double even_chance = 0.5;

double square(double value) {
    return value * value;
}

/// The difference that is expected where one within the margin was measured. The mean of the square of an estimate is
/// the square of the difference and that of the estimate's own error; it is taken off.
double withoutItsError(double estimate, double error) {
    return std::copysign(std::sqrt(std::max(0.0, square(estimate) - square(error))), estimate);
}

/// The probability that an interval which is expected there lies within the margin, if its place has this error.
double chanceWithin(const Interval& expected, double margin, double error) {
    const double above = margin - expected.high, below = -margin - expected.low;
    if (error <= 0.0)
        return above >= 0.0 && below <= 0.0 ? 1.0 : 0.0;
    return normalCumulative(above / error) - normalCumulative(below / error);
}

/// So many times the pairs make it as likely as not that the interval lies within the margin. Bisection of the root,
/// because the chance grows with it.
double timesToBeEqual(const MeasuredDifference& measured, double margin) {
    const double below = measured.estimate - measured.interval.low, above = measured.interval.high - measured.estimate;
    const double error = (below + above) / (2.0 * normalReach(measured.confidence));
    const double expected = withoutItsError(measured.estimate, error);
    double low = 0.0, high = std::sqrt(2.0 * most_pairs);
    for (int i = 0; i < 60; ++i) {
        const double root = (low + high) / 2.0;
        const Interval interval{expected - below / root, expected + above / root};
        (chanceWithin(interval, margin, error / root) >= even_chance ? high : low) = root; // also if it is no number
    }
    return square(high);
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
    return timesToBeEqual(measured, margin);
}

/// So many times the pairs make the test agree that there is a difference; equality asks for no test.
double timesForTest(const MeasuredDifference& measured, double margin) {
    if (std::abs(measured.estimate) <= margin || measured.p < measured.needed_p)
        return 1.0;
    return square(normalReach(1.0 - measured.needed_p) / normalReach(1.0 - measured.p));
}

/// These are the counts that `pairs` pairs would probably have.
struct ExpectedCount {
    PairedCount count;
    double error = 0.0; ///< standard error of the difference of its rates
};

/// As many pairs of each kind as `pairs` of all would have. A difference within the margin is taken without its error.
ExpectedCount expectedOf(const PairedCount& count, double margin, std::size_t pairs) {
    const double now = static_cast<double>(count.pairs()), later = static_cast<double>(pairs);
    const double differing = static_cast<double>(count.baseline_only + count.candidate_only) / now;
    const double measured =
        (static_cast<double>(count.candidate_only) - static_cast<double>(count.baseline_only)) / now;
    const double error = std::sqrt((differing - square(measured)) / now);
    const double difference = std::abs(measured) > margin ? measured : withoutItsError(measured, error);
    const auto part = [](double number) { return static_cast<std::size_t>(std::llround(number)); };
    return {{part(later * static_cast<double>(count.both) / now), part(later * (differing - difference) / 2.0),
             part(later * (differing + difference) / 2.0), part(later * static_cast<double>(count.neither) / now)},
            std::sqrt((differing - square(difference)) / later)};
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
    const auto isDecided = [&](const PairedCount& counted, const Interval& interval, double error) {
        const bool is_beyond = interval.low > margin || interval.high < -margin;
        return chanceWithin(interval, margin, error) >= even_chance || (is_beyond && mcNemar(counted) < needed_p);
    };
    if (isDecided(count, rateDifference(count, confidence), 0.0))
        return 0;
    for (std::size_t pairs = now + 1; pairs <= static_cast<std::size_t>(most_pairs);
         pairs += std::max<std::size_t>(1, pairs / 100)) {
        const auto& [expected, error] = expectedOf(count, margin, pairs);
        if (isDecided(expected, rateDifference(expected, confidence), error))
            return pairs - now;
    }
    return std::nullopt;
}

} // namespace usar::campaign
