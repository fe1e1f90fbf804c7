// Why runs of a campaign were not done: the runs grouped by what ended them.
#pragma once

#include <string>
#include <vector>

#include "core/campaign/runs/run_result.h"

namespace usar::campaign {

/// Runs of any variant that ended for the same reason.
struct FailureCause {
    Outcome outcome = Outcome::Failed;
    std::string reason;               ///< It has lost its numbers.
    std::vector<std::size_t> indices; ///< They tell the runs among those that were given, in their order.
    bool operator==(const FailureCause&) const = default;
};

/// Groups all runs that were not done by outcome and reason; the most frequent cause comes first, and of equally
/// frequent ones that with the earlier run.
std::vector<FailureCause> failureCauses(const std::vector<RunResult>& runs);

} // namespace usar::campaign
