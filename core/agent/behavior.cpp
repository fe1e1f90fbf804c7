#include "core/agent/behavior.h"

namespace usar::agent {

Behavior::~Behavior() = default;

void Behavior::onInfo(const protocol::InfoLine&, CommandPort&) {}

void Behavior::control(const PlanControl& control, CommandPort& port) {
    if (const auto* const asked = std::get_if<ReplacePlan>(&control))
        port.publish(PlanReplaced{.fate = PlanFate::Refused,
                                  .plan_name = asked->plan.name,
                                  .reason = "No plan decides what this behavior does."});
}

} // namespace usar::agent
