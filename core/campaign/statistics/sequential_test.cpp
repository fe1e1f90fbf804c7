#include "core/campaign/statistics/sequential_test.h"

#include <cmath>
#include <numbers>

#include "core/campaign/statistics/normal.h"

namespace usar::campaign {

namespace {

/// The logarithm of the mean of (2q)^wins (2(1-q))^losses over all q from 1/2 to 1. The integral is an incomplete beta
/// function.
double logarithmOfWealth(std::size_t wins, std::size_t losses) {
    const double a = static_cast<double>(wins) + 1.0, b = static_cast<double>(losses) + 1.0;
    const double logarithm_of_beta = std::lgamma(a) + std::lgamma(b) - std::lgamma(a + b);
    return (a + b - 1.0) * std::numbers::ln2 + logarithm_of_beta + std::log(Eigen::numext::betainc(b, a, 0.5));
}

} // namespace

void SequentialTest::add(double gain) {
    if (gain > margin_)
        ++wins_;
    else if (gain < -margin_)
        ++losses_;
    else
        ++ties_;
    if (verdict_ != SequentialVerdict::Undecided || pairs() < least_pairs)
        return;
    const double enough = std::log(2.0 / alpha_);
    if (evidenceForBetter() >= enough)
        verdict_ = SequentialVerdict::Better;
    else if (evidenceForWorse() >= enough)
        verdict_ = SequentialVerdict::Worse;
}

double SequentialTest::evidenceForBetter() const {
    return logarithmOfWealth(wins_, losses_);
}

double SequentialTest::evidenceForWorse() const {
    return logarithmOfWealth(losses_, wins_);
}

} // namespace usar::campaign
