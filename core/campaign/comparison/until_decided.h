// What a campaign that stops as soon as it is decided feeds to its sequential test.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/campaign/comparison/pairing.h"
#include "core/campaign/runs/run_result.h"
#include "core/campaign/statistics/sequential_test.h"

namespace usar::campaign {

/// The candidate's gain in one pair, as a multiple of the metric's margin, for SequentialTest(1.0). Success comes
/// first: infinite where only the candidate was done, minus infinite where only the baseline was, and 0 where neither
/// was. A margin that is a share is one of this pair's baseline, because the median of all is not known yet. Nothing
/// where a run was refused or killed, or has no such figure; such a pair is not fed. Feed pairs in the order of their
/// seeds, not as they finish: what finishes first is not chosen by chance, on which the test relies.
std::optional<double> scaledGain(const RunPair& pair, const Metric& metric);

/// Follows a campaign of two variants and says when it is decided, by success and then by the duration. It takes
/// results in any order and feeds the test in the order of the pairs.
class DecisionWatch {
public:
    DecisionWatch(std::string baseline, std::string candidate);

    /// Takes a result; each run once.
    void take(const RunResult& result);
    SequentialVerdict verdict() const { return test_.verdict(); }
    /// Pairs that the test has seen.
    std::size_t pairs() const { return test_.pairs(); }

private:
    struct Pair {
        std::optional<RunFigures> baseline;
        std::optional<RunFigures> candidate;
    };

    std::string baseline_;
    std::string candidate_;
    Metric metric_;
    SequentialTest test_{1.0};
    std::map<int, Pair> waiting_; ///< by the number of the pair
    int next_ = 0;
};

} // namespace usar::campaign
