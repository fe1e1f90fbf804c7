// The selected node of a drawn plan, the nodes that a search has found, and the steps of keyboard navigation.
#pragma once

#include <algorithm>
#include <utility>
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

/// A value. Nodes are those of the tree that it was last used with.
class PlanSelection {
public:
    PlanNodeId node() const { return node_; }
    /// Returns true if another node was selected before.
    bool set(PlanNodeId node) { return std::exchange(node_, node) != node; }
    /// Selects the same part in another tree, found by its names; if that part is now drawn elsewhere, by its path.
    /// Forgets the search.
    void moveTo(const PlanTree& to, const PlanTree& from);

    /// Replaces the search; finds nothing if `words` is empty.
    void search(const PlanTree& tree, const QString& words);
    /// The nodes that were found, in ascending order.
    const std::vector<PlanNodeId>& found() const { return found_; }
    /// The same by node: true if it was found; empty if none was.
    const std::vector<bool>& foundByNode() const { return found_by_node_; }
    bool isFound() const { return std::ranges::binary_search(found_, node_); }
    /// The found node after or before the selected one, wrapping around at both ends; none if none was found.
    PlanNodeId nextFound(bool backward) const { return nextOf(found_, node_, backward); }

private:
    PlanNodeId node_;
    std::vector<PlanNodeId> found_;
    std::vector<bool> found_by_node_;
};

} // namespace usar::widgets
