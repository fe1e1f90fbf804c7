// The runs that somebody should look at: the worst ones, and why runs were not done.
#pragma once

#include <compare>
#include <optional>
#include <string>
#include <vector>

#include "core/campaign/comparison/comparison.h"

namespace usar::campaign {

/// The runs of both variants from the worst on, at most `most` of them: first those whose program died, then those that
/// failed, each by how little they covered; then those that were done, by how long they took. Refused and killed runs
/// are not among them.
std::vector<const RunFigures*> worstRuns(const Comparison& comparison, std::size_t most);
/// The same of any runs, which are all that count.
std::vector<const RunFigures*> worstOf(std::vector<const RunFigures*> runs, std::size_t most);

/// The reason with "#" in place of each number and its sign, because times and places differ from run to run. Digits of
/// a name, as in "R1", stay.
std::string withoutNumbers(const std::string& text);

/// A square of 10 m of the ground; its numbers times 10 m are its lower corner, in the map frame.
struct PlaceSquare {
    int x = 0;
    int y = 0;
    auto operator<=>(const PlaceSquare&) const = default;
};

PlaceSquare squareOf(const QPointF& point_m);
/// "around x 15 m, y -5 m", which is the middle of the square; empty where no place is known.
std::string wordsOf(const std::optional<PlaceSquare>& place);

/// Where a run ended that was not done: at its last collision, or where its path ends; nullopt if neither is known.
std::optional<PlaceSquare> endOf(const RunFigures& run);

/// Runs of one group that ended in one square of the ground.
struct FailurePlace {
    std::optional<PlaceSquare> place;
    std::size_t of_baseline = 0;
    std::size_t of_candidate = 0;

    std::size_t size() const { return of_baseline + of_candidate; }
};

/// Runs that were not done for the same reason.
struct FailureGroup {
    Outcome outcome = Outcome::Failed;
    std::string reason; ///< without its numbers
    std::size_t of_baseline = 0;
    std::size_t of_candidate = 0;
    const RunFigures* example = nullptr; ///< the first one; belongs to whoever has the runs
    std::vector<FailurePlace> places{};  ///< the most frequent first, and the unknown last

    std::size_t size() const { return of_baseline + of_candidate; }
};

/// All runs of both variants that were not done, also the refused and killed; the largest group first.
std::vector<FailureGroup> failureGroups(const Comparison& comparison, const std::vector<RunFigures>& runs);
/// The same of these two variants; with an empty candidate of the baseline alone.
std::vector<FailureGroup> failureGroups(const std::string& baseline, const std::string& candidate,
                                        const std::vector<RunFigures>& runs);

} // namespace usar::campaign
