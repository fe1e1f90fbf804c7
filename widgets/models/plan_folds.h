// Which parts of a drawn plan are folded: kept by the names that lead to them, so that they survive an edit.
#pragma once

#include <unordered_set>
#include <vector>

#include "widgets/models/plan_tree.h"

namespace usar::widgets {

class PlanFolds {
public:
    bool folded(const PlanTree& tree, int node) const { return keys_.contains(tree[node].key); }
    /// Folding what has nothing below it says nothing.
    void set(const PlanTree& tree, int node, bool folded);
    void unfoldAll() { keys_.clear(); }
    /// All but the roots.
    void foldAll(const PlanTree& tree);
    /// Opens the way to these nodes and folds everything else.
    void showOnly(const PlanTree& tree, const std::vector<int>& nodes);
    /// Opens all that a node stands in. True if something was folded.
    bool reveal(const PlanTree& tree, int node);
    bool operator==(const PlanFolds&) const = default;

private:
    std::unordered_set<std::uint64_t> keys_;
};

} // namespace usar::widgets
