#include "core/campaign/comparison/failure_causes.h"

#include <algorithm>
#include <map>

#include "core/campaign/comparison/failures.h"

namespace usar::campaign {

std::vector<FailureCause> failureCauses(const std::vector<RunResult>& runs) {
    std::vector<FailureCause> causes;
    std::map<std::pair<Outcome, std::string>, std::size_t> known;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (runs[i].outcome == Outcome::Done)
            continue;
        const std::string reason = withoutNumbers(runs[i].reason);
        const auto [at, is_new] = known.try_emplace({runs[i].outcome, reason}, causes.size());
        if (is_new)
            causes.push_back({runs[i].outcome, reason, {}});
        causes[at->second].indices.push_back(i);
    }
    std::ranges::stable_sort(
        causes, [](const FailureCause& a, const FailureCause& b) { return a.indices.size() > b.indices.size(); });
    return causes;
}

} // namespace usar::campaign
