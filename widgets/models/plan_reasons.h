// Why an element of a running plan runs, or why it does not: which sense said no, with what value, since when.
#pragma once

#include <vector>

#include <QString>

#include "widgets/models/plan_activity.h"

namespace usar::widgets {

enum class PlanVerdict { Yes, No, Open };

/// One cause, as a sentence; `node` is where it stands.
struct PlanReason {
    PlanVerdict verdict = PlanVerdict::Open;
    QString text;
    int node = -1;
    bool operator==(const PlanReason&) const = default;
};

/// The answer in one sentence: "avoid does not run: a sense above it says no."
QString planVerdict(const PlanTree& tree, const PlanStates& states, int node);
/// The causes from the root to the node itself.
std::vector<PlanReason> planReasons(const PlanTree& tree, const PlanStates& states, int node);

/// "no, it is 0.12, for 8.0 s": what a sense answered last, and since when that has been the verdict.
QString answerText(const PlanActivity& state, Seconds now);
/// "12 starts, 9 succeeded, 2 failed, 4 times held back"; empty before the first.
QString countersText(const PlanActivity& state);
/// "runs now", "ran 3.2 s ago", "has not run yet".
QString lastRunText(const PlanActivity& state, Seconds now);

} // namespace usar::widgets
