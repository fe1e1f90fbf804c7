#include "widgets/models/plan/plan_marks.h"

namespace usar::widgets {

namespace {

void merge(PlanMark& into, const PlanMark& from) {
    into.breakpoints += from.breakpoints;
    into.breakpoints_off += from.breakpoints_off;
    into.conditional = into.conditional || from.conditional;
    into.pinned = into.pinned || from.pinned;
    into.switched_off = into.switched_off || from.switched_off;
    into.halted = into.halted || from.halted;
    for (const QString& line : from.words)
        if (!into.words.contains(line))
            into.words << line;
}

} // namespace

PlanMarks::PlanMarks(const PlanTree& tree, const std::vector<PlanMark>& marks) {
    for (const PlanMark& mark : marks) {
        const PlanNodeId node = tree.find(mark.path);
        if (!node.valid())
            continue;
        merge(by_node_[node], mark);
        if (const PlanNodeId drawn = tree[node].link; drawn.valid())
            merge(by_node_[drawn], mark);
    }
}

const PlanMark* PlanMarks::at(PlanNodeId node) const {
    const auto found = by_node_.find(node);
    return found == by_node_.end() ? nullptr : &found->second;
}

} // namespace usar::widgets
