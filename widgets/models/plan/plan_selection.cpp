#include "widgets/models/plan/plan_selection.h"

#include <algorithm>
#include <utility>

#include "widgets/models/plan/plan_walk.h"

namespace usar::widgets {

bool PlanSelection::set(PlanNodeId node) {
    return std::exchange(node_, node) != node;
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

bool PlanSelection::isFound() const {
    return std::binary_search(found_.begin(), found_.end(), node_);
}

PlanNodeId PlanSelection::nextFound(bool backward) const {
    return nextOf(found_, node_, backward);
}

} // namespace usar::widgets
