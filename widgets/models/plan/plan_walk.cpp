#include "widgets/models/plan/plan_walk.h"

#include <algorithm>

namespace usar::widgets {

namespace {

/// Steps down from a card to its senses, and from the last of them to the next card; and in reverse.
int sibling(const PlanTree& tree, int node, int by) {
    const PlanNode& what = tree[node];
    if (by > 0 && what.senses > 0)
        return node + 1;
    if (what.in_card && (by < 0 || node + by <= what.parent + tree[what.parent].senses))
        return node + by;
    const int card = what.in_card ? what.parent : node;
    if (tree[card].parent < 0)
        return -1;
    const auto cards = tree.children(tree[card].parent);
    const auto here = std::find(cards.begin(), cards.end(), card) - cards.begin() + by;
    if (here < 0 || here >= std::ssize(cards))
        return -1;
    const int next = cards[static_cast<std::size_t>(here)];
    return by < 0 ? next + tree[next].senses : next;
}

} // namespace

int planStep(const PlanTree& tree, int node, PlanStep step) {
    if (node < 0)
        return tree.empty() ? -1 : 0;
    switch (step) {
    case PlanStep::Out:
        return tree[node].parent;
    case PlanStep::In:
        return tree.children(node).empty() ? tree[node].link : tree.children(node).front();
    case PlanStep::Before:
        return sibling(tree, node, -1);
    case PlanStep::After:
        return sibling(tree, node, 1);
    }
    return -1;
}

int nextOf(const std::vector<int>& nodes, int node, bool backward) {
    if (nodes.empty())
        return -1;
    if (backward) {
        const auto here = std::lower_bound(nodes.begin(), nodes.end(), node);
        return here == nodes.begin() ? nodes.back() : *(here - 1);
    }
    const auto after = std::upper_bound(nodes.begin(), nodes.end(), node);
    return after == nodes.end() ? nodes.front() : *after;
}

} // namespace usar::widgets
