#include "widgets/models/plan/plan_activity.h"

#include <algorithm>
#include <cmath>

namespace usar::widgets {

namespace {

void merge(PlanActivity& into, const PlanActivity& from) {
    into.running = into.running || from.running;
    if (from.last_active && (!into.last_active || *from.last_active > *into.last_active))
        into.last_active = from.last_active;
    into.started += from.started;
    into.succeeded += from.succeeded;
    into.failed += from.failed;
    into.skipped += from.skipped;
    if (!from.hold_back.isEmpty())
        into.hold_back = from.hold_back;
    if (from.answer && (!into.answer || from.answer->asked > into.answer->asked))
        into.answer = from.answer;
}

} // namespace

void PlanStates::reset(const PlanTree& tree) {
    states_.assign(static_cast<std::size_t>(tree.size()), {});
    paths_.reset();
    node_of_path_.clear();
    strangers_ = 0;
}

void PlanStates::take(const PlanTree& tree, const PlanSnapshot& snapshot) {
    if (snapshot.paths != paths_) {
        paths_ = snapshot.paths;
        node_of_path_.clear();
        if (paths_)
            for (const std::string& path : *paths_)
                node_of_path_.push_back(tree.find(path));
        strangers_ = static_cast<int>(std::ranges::count(node_of_path_, PlanNodeId{}));
    }
    now_ = snapshot.now;
    states_.assign(static_cast<std::size_t>(tree.size()), {});
    const std::size_t count = std::min(node_of_path_.size(), snapshot.activities.size());
    for (std::size_t i = 0; i < count; ++i) {
        const PlanNodeId node = node_of_path_[i];
        if (!node.valid())
            continue;
        merge(states_[node.index()], snapshot.activities[i]);
        if (const PlanNodeId drawn = tree[node].link; drawn.valid())
            merge(states_[drawn.index()], snapshot.activities[i]);
    }
}

double PlanStates::recency(PlanNodeId node) const {
    const PlanActivity& state = (*this)[node];
    if (state.running)
        return 1.0;
    if (!state.last_active)
        return 0.0;
    const double age_s = std::max(0.0, (now_ - *state.last_active).count());
    const double left = std::exp2(-age_s / half_life.count());
    return left < 0.02 ? 0.0 : left;
}

std::vector<PlanNodeId> PlanStates::running(const PlanTree& tree) const {
    std::vector<PlanNodeId> nodes;
    for (const PlanNodeId node : tree.nodes())
        if ((*this)[node].running && !tree[node].in_card)
            nodes.push_back(node);
    return nodes;
}

} // namespace usar::widgets
