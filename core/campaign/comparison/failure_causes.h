// Why runs of a campaign were not done: the runs grouped by what ended them.
#pragma once

#include <string>
#include <vector>

#include "core/campaign/runs/run_result.h"

namespace usar::campaign {

/// Runs of any variant that ended for the same reason.
struct FailureCause {
    Outcome outcome = Outcome::Failed;
    std::string reason; ///< It has lost its numbers.
    std::vector<std::size_t>
        indices; ///< They tell the runs among those that were given, by place, then in their order.
    std::vector<std::string> places{}; ///< They tell where each of them ended, in words; empty if it is not known.
    bool operator==(const FailureCause&) const = default;
};

/// Groups all runs that were not done by outcome and reason, and those of one cause by the square of the ground in
/// which they ended. The most frequent cause and the most frequent place come first, of equally frequent ones that with
/// the earlier run; runs of which no place is known come last.
std::vector<FailureCause> failureCauses(const std::vector<RunResult>& runs);

/// How often each variant is among these runs: "3 × C++, 1 × POSH".
std::string variantCounts(const std::vector<RunResult>& runs, const std::vector<std::size_t>& indices);

} // namespace usar::campaign
