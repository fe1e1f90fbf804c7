#include "core/mission/session/behavior_so_far.h"

#include "core/posh/trace/trace_codec.h"

namespace usar::mission {

bool replacesItsPredecessor(const agent::Published& value) {
    return std::holds_alternative<agent::BehaviorStatus>(value) || std::holds_alternative<agent::SonarZones>(value) ||
           std::holds_alternative<agent::PlannedPath>(value) || std::holds_alternative<agent::CurrentGoal>(value);
}

void BehaviorSoFar::take(const agent::Published& value) {
    if (const auto* const trace = std::get_if<agent::PlanTrace>(&value)) {
        if (trace->bytes.starts_with(posh::trace_codec::magic))
            trace_.clear();
        trace_ += trace->bytes;
    } else if (const auto* const halted = std::get_if<agent::PlanHalted>(&value)) {
        halted_ = *halted;
    } else if (std::holds_alternative<agent::PlanResumed>(value)) {
        halted_.reset();
    } else if (replacesItsPredecessor(value)) {
        newest_.insert_or_assign(value.index(), value);
    }
}

std::vector<agent::Published> BehaviorSoFar::all() const {
    std::vector<agent::Published> values;
    if (!trace_.empty())
        values.emplace_back(agent::PlanTrace{trace_});
    for (const auto& [kind, value] : newest_)
        values.push_back(value);
    if (halted_)
        values.emplace_back(*halted_);
    return values;
}

} // namespace usar::mission
