// A node of a drawn plan and its state, described in full for people: tooltips and screen readers.
#pragma once

#include <QString>

#include "widgets/models/plan/plan_activity.h"
#include "widgets/models/plan/plan_folds.h"
#include "widgets/models/plan/plan_marks.h"

namespace usar::widgets {

/// Several lines: what it is, its priority and comment, its newest answer or last run, counters, marks, where a link
/// leads, what is folded away, and its place in the text.
QString planNodeText(const PlanTree& tree, const PlanStates& states, const PlanFolds& folds, const PlanMarks& marks,
                     PlanNodeId node);
/// Says in which respect a drawing of this state is incomplete; empty if it is complete.
QString planReservation(const PlanTree& tree, const PlanStates& states);

} // namespace usar::widgets
