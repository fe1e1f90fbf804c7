// The runs that somebody should look at: the worst ones, and why runs were not done.
#pragma once

#include <string>
#include <vector>

#include "core/campaign/comparison/comparison.h"

namespace usar::campaign {

/// The runs of both variants from the worst on, at most `most` of them: first those whose program died, then those that
/// failed, each by how little they covered; then those that were done, by how long they took. Refused and killed runs
/// are not among them.
std::vector<const RunFigures*> worstRuns(const Comparison& comparison, std::size_t most);

/// The reason with "#" in place of each number, because times and places differ from run to run.
std::string withoutNumbers(const std::string& text);

/// Runs that were not done for the same reason.
struct FailureGroup {
    Outcome outcome = Outcome::Failed;
    std::string reason; ///< without its numbers
    std::size_t of_baseline = 0;
    std::size_t of_candidate = 0;
    const RunFigures* example = nullptr; ///< the first one; belongs to whoever has the runs

    std::size_t size() const { return of_baseline + of_candidate; }
};

/// All runs of both variants that were not done, also the refused and killed; the largest group first.
std::vector<FailureGroup> failureGroups(const Comparison& comparison, const std::vector<RunFigures>& runs);

} // namespace usar::campaign
