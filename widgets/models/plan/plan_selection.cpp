#include "widgets/models/plan/plan_selection.h"

namespace usar::widgets {

namespace {

/// Steps down from a card to its senses, and from the last of them to the next card; and in reverse.
PlanNodeId sibling(const PlanTree& tree, PlanNodeId node, int by) {
    const PlanNode& what = tree[node];
    if (by > 0 && what.senses > 0)
        return {node.value + 1};
    if (what.in_card && (by < 0 || node.value + by <= what.parent.value + tree[what.parent].senses))
        return {node.value + by};
    const PlanNodeId card = tree.cardOf(node);
    if (!tree[card].parent.valid())
        return {};
    const auto cards = tree.children(tree[card].parent);
    const auto here = std::find(cards.begin(), cards.end(), card) - cards.begin() + by;
    if (here < 0 || here >= std::ssize(cards))
        return {};
    const PlanNodeId next = cards[static_cast<std::size_t>(here)];
    return by < 0 ? PlanNodeId{next.value + tree[next].senses} : next;
}

} // namespace

PlanNodeId planStep(const PlanTree& tree, PlanNodeId node, PlanStep step) {
    if (!node.valid())
        return tree.empty() ? PlanNodeId{} : PlanNodeId{0};
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
    return {};
}

PlanNodeId nextOf(const std::vector<PlanNodeId>& nodes, PlanNodeId node, bool backward) {
    if (nodes.empty())
        return {};
    if (backward) {
        const auto here = std::lower_bound(nodes.begin(), nodes.end(), node);
        return here == nodes.begin() ? nodes.back() : *(here - 1);
    }
    const auto after = std::upper_bound(nodes.begin(), nodes.end(), node);
    return after == nodes.end() ? nodes.front() : *after;
}

void PlanSelection::moveTo(const PlanTree& to, const PlanTree& from) {
    found_.clear();
    found_by_node_.clear();
    if (!node_.valid())
        return;
    const PlanNodeId same = to.findKey(from[node_].key);
    node_ = same.valid() ? same : to.find(from.path(node_));
}

void PlanSelection::search(const PlanTree& tree, const QString& words) {
    found_ = tree.search(words);
    found_by_node_.assign(found_.empty() ? 0 : static_cast<std::size_t>(tree.size()), false);
    for (const PlanNodeId node : found_)
        found_by_node_[node.index()] = true;
}

} // namespace usar::widgets
