#include "core/campaign/comparison/until_decided.h"

#include "core/campaign/comparison/campaign_figures.h"

#include <limits>

namespace usar::campaign {

std::optional<double> scaledGain(const RunPair& pair, const Metric& metric) {
    if (!counts(pair.baseline->outcome) || !counts(pair.candidate->outcome))
        return std::nullopt;
    const bool before = pair.baseline->outcome == Outcome::Done, after = pair.candidate->outcome == Outcome::Done;
    if (before != after)
        return (after ? 1.0 : -1.0) * std::numeric_limits<double>::infinity();
    if (!before)
        return 0.0;
    const auto baseline = valueOf(*pair.baseline, metric), candidate = valueOf(*pair.candidate, metric);
    if (!baseline || !candidate)
        return std::nullopt;
    const double gain = metric.lower_is_better ? *baseline - *candidate : *candidate - *baseline;
    // Without a difference there is none, also where the margin is zero.
    return gain == 0.0 ? 0.0 : gain / marginOf(metric, *baseline);
}

DecisionWatch::DecisionWatch(std::string baseline, std::string candidate)
    : baseline_(std::move(baseline))
    , candidate_(std::move(candidate))
    , metric_(usualMetrics().front()) {}

void DecisionWatch::take(const RunResult& result) {
    Pair& pair = waiting_[result.pair];
    if (result.variant == baseline_)
        pair.baseline = figuresOf(result);
    else if (result.variant == candidate_)
        pair.candidate = figuresOf(result);
    for (auto first = waiting_.find(next_); first != waiting_.end(); first = waiting_.find(++next_)) {
        const Pair& complete = first->second;
        if (!complete.baseline || !complete.candidate)
            return;
        if (const auto gain = scaledGain({&*complete.baseline, &*complete.candidate}, metric_))
            test_.add(*gain);
        waiting_.erase(first);
    }
}

} // namespace usar::campaign
