#include "core/campaign/statistics/proportion.h"

#include <algorithm>
#include <cmath>

#include "core/campaign/statistics/normal.h"

namespace usar::campaign {

namespace {

/// The rate below which a beta distribution holds `probability`. Bisection, because the incomplete beta function only
/// grows, and halving 60 times leaves less than a double can tell.
double betaQuantile(double a, double b, double probability) {
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2.0;
        (Eigen::numext::betainc(a, b, middle) < probability ? low : high) = middle;
    }
    return (low + high) / 2.0;
}

} // namespace

double Count::rate() const {
    return trials == 0 ? 0.0 : static_cast<double>(successes) / static_cast<double>(trials);
}

Interval wilsonInterval(const Count& count, double confidence) {
    if (count.trials == 0)
        return {0.0, 1.0};
    const double n = static_cast<double>(count.trials), rate = count.rate();
    const double z = normalReach(confidence), z2 = z * z;
    const double center = (rate + z2 / (2.0 * n)) / (1.0 + z2 / n);
    const double reach = z / (1.0 + z2 / n) * std::sqrt(rate * (1.0 - rate) / n + z2 / (4.0 * n * n));
    // The formula gives exactly 0 and 1 at the ends, and rounding must not go past them.
    return {count.successes == 0 ? 0.0 : std::max(0.0, center - reach),
            count.successes == count.trials ? 1.0 : std::min(1.0, center + reach)};
}

Interval clopperPearsonInterval(const Count& count, double confidence) {
    const double one_sided = 0.5 + confidence / 2.0;
    return {lowestRate(count, one_sided), highestRate(count, one_sided)};
}

double highestRate(const Count& count, double confidence) {
    if (count.successes == count.trials)
        return 1.0;
    return betaQuantile(static_cast<double>(count.successes + 1), static_cast<double>(count.trials - count.successes),
                        confidence);
}

double lowestRate(const Count& count, double confidence) {
    return 1.0 - highestRate({count.trials - count.successes, count.trials}, confidence);
}

double mcNemar(const PairedCount& count) {
    const std::size_t fewer = std::min(count.baseline_only, count.candidate_only);
    const std::size_t more = std::max(count.baseline_only, count.candidate_only);
    if (fewer == more)
        return 1.0;
    return std::min(1.0, 2.0 * Eigen::numext::betainc(static_cast<double>(more), static_cast<double>(fewer + 1), 0.5));
}

Interval rateDifference(const PairedCount& count, double confidence) {
    if (count.pairs() == 0)
        return {-1.0, 1.0};
    const double n = static_cast<double>(count.pairs()) + 2.0;
    const double gained = (static_cast<double>(count.candidate_only) + 1.0) / n;
    const double lost = (static_cast<double>(count.baseline_only) + 1.0) / n;
    const double difference = gained - lost;
    const double reach = normalReach(confidence) * std::sqrt((gained + lost - difference * difference) / n);
    return {std::max(-1.0, difference - reach), std::min(1.0, difference + reach)};
}

} // namespace usar::campaign
