// Which parts of a drawn plan are folded; stored by the names on the path to them, so that folds survive an edit.
#pragma once

#include <unordered_set>
#include <vector>

#include "widgets/models/plan/plan_tree.h"

namespace usar::widgets {

/// Nodes without children cannot be folded.
class PlanFolds {
public:
    /// True if the node's children are hidden.
    bool folded(const PlanTree& tree, PlanNodeId node) const { return keys_.contains(tree[node].key); }
    /// Folds or unfolds; folding a node without children unfolds it.
    void set(const PlanTree& tree, PlanNodeId node, bool folded);
    void unfoldAll() { keys_.clear(); }
    /// Folds everything except the roots.
    void foldAll(const PlanTree& tree);
    /// Folds everything except the paths to these nodes.
    void showOnly(const PlanTree& tree, const std::vector<PlanNodeId>& nodes);
    /// Unfolds everything that contains the node. Returns true if something was folded.
    bool reveal(const PlanTree& tree, PlanNodeId node);
    bool operator==(const PlanFolds&) const = default;

private:
    std::unordered_set<std::uint64_t> keys_;
};

} // namespace usar::widgets
