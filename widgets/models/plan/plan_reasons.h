// Describes the parts of a running plan in words, and explains why one runs or does not: which sense refused it, with
// which value, since when.
#pragma once

#include <optional>
#include <vector>

#include <QString>

#include "widgets/models/plan/plan_activity.h"
#include "widgets/models/plan/plan_layout.h"
#include "widgets/models/plan/plan_marks.h"

namespace usar::widgets {

/// Effect of a cause: it favors running, prevents it, or is not known yet.
enum class PlanVerdict { Yes, No, Open };

/// One cause as a sentence; `node` is the part that it refers to, which may be another one than asked about.
struct PlanReason {
    PlanVerdict verdict = PlanVerdict::Open;
    QString text{};
    PlanNodeId node{};
    std::optional<Seconds> since{}; ///< time at which a sense's present verdict began; nullopt: no sense, or not asked
};

/// The verdict in one sentence: "avoid does not run, for one reason:".
QString planVerdict(const PlanTree& tree, const PlanStates& states, PlanNodeId node);
/// The causes, in order from the root to the node.
std::vector<PlanReason> planReasons(const PlanTree& tree, const PlanStates& states, PlanNodeId node);
/// What prevents the drives that do not run, in the order of the tree; a cause that several share is listed once.
std::vector<PlanReason> driveRefusals(const PlanTree& tree, const PlanStates& states);

/// "no, it is 0.12, for 8.0 s": the sense's newest answer, and how long this has been the verdict.
QString answerText(const PlanActivity& state, Seconds now);
/// "12 starts, 9 successes, 2 failures, held back 4 times"; empty if all are 0.
QString countersText(const PlanActivity& state);
/// "runs now", "ran 3.2 s ago", "has not run yet".
QString lastRunText(const PlanActivity& state, Seconds now);

/// Full description for tooltips and screen readers, in several lines: what it is, its priority and comment, its newest
/// answer or last run, counters, marks, where a link leads, what is folded away, and its place in the text.
QString planNodeText(const PlanTree& tree, const PlanStates& states, const PlanFolds& folds, const PlanMarks& marks,
                     PlanNodeId node);
/// Says in which respect a drawing of this state is incomplete; empty if it is complete.
QString planReservation(const PlanTree& tree, const PlanStates& states);

} // namespace usar::widgets
