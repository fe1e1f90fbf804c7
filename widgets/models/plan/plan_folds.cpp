#include "widgets/models/plan/plan_folds.h"

namespace usar::widgets {

void PlanFolds::set(const PlanTree& tree, PlanNodeId node, bool folded) {
    if (folded && !tree.children(node).empty())
        keys_.insert(tree[node].key);
    else
        keys_.erase(tree[node].key);
}

void PlanFolds::foldAll(const PlanTree& tree) {
    for (const PlanNodeId node : tree.nodes())
        if (tree[node].parent.valid())
            set(tree, node, true);
}

void PlanFolds::showOnly(const PlanTree& tree, const std::vector<PlanNodeId>& nodes) {
    foldAll(tree);
    for (const PlanNodeId node : nodes)
        reveal(tree, node);
}

bool PlanFolds::reveal(const PlanTree& tree, PlanNodeId node) {
    const PlanNodeId card = tree[node].in_card ? tree[node].parent : node; // A sense is visible if its card is.
    bool changed = false;
    for (PlanNodeId at = tree[card].parent; at.valid(); at = tree[at].parent)
        changed = keys_.erase(tree[at].key) > 0 || changed;
    return changed;
}

} // namespace usar::widgets
