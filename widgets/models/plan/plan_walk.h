// Steps between the nodes of a drawn plan, for keyboard navigation.
#pragma once

#include <vector>

#include "widgets/models/plan/plan_tree.h"

namespace usar::widgets {

/// Out: to the node that contains it. In: to its first child, or along its link. Before and After: to its neighbors at
/// the same depth, where the senses of a card follow the card.
enum class PlanStep { Out, In, Before, After };

/// Returns the node that a step leads to: the first node if `node` is none; none if there is none in that direction.
PlanNodeId planStep(const PlanTree& tree, PlanNodeId node, PlanStep step);

/// Returns the entry of `nodes` (in ascending order) after or before `node`, wrapping around at both ends; none if
/// `nodes` is empty. `node` need not be among them; none is before all of them.
PlanNodeId nextOf(const std::vector<PlanNodeId>& nodes, PlanNodeId node, bool backward);

} // namespace usar::widgets
