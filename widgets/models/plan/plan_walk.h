// Steps from node to node of a drawn plan, as the keys make them.
#pragma once

#include <vector>

#include "widgets/models/plan/plan_tree.h"

namespace usar::widgets {

/// Out: to the node that contains it. In: to its first child, or along its link. Before and After: to its neighbors at
/// the same depth, where the senses of a card follow the card.
enum class PlanStep { Out, In, Before, After };

/// The node that a step leads to: the first one if `node` is -1, and -1 at an end.
int planStep(const PlanTree& tree, int node, PlanStep step);

/// Of nodes in ascending order, the next one after `node` or before it, around both ends; -1 if there are none. `node`
/// need not be among them; -1 is before all of them.
int nextOf(const std::vector<int>& nodes, int node, bool backward);

} // namespace usar::widgets
