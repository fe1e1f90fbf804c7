#include "widgets/models/plan/plan_folds.h"

namespace usar::widgets {

void PlanFolds::set(const PlanTree& tree, int node, bool folded) {
    if (folded && !tree.children(node).empty())
        keys_.insert(tree[node].key);
    else
        keys_.erase(tree[node].key);
}

void PlanFolds::foldAll(const PlanTree& tree) {
    for (int node = 0; node < tree.size(); ++node)
        if (tree[node].parent >= 0)
            set(tree, node, true);
}

void PlanFolds::showOnly(const PlanTree& tree, const std::vector<int>& nodes) {
    foldAll(tree);
    for (const int node : nodes)
        reveal(tree, node);
}

bool PlanFolds::reveal(const PlanTree& tree, int node) {
    const int card = tree[node].in_card ? tree[node].parent : node; // A sense is visible if its card is.
    bool changed = false;
    for (int at = tree[card].parent; at >= 0; at = tree[at].parent)
        changed = keys_.erase(tree[at].key) > 0 || changed;
    return changed;
}

} // namespace usar::widgets
