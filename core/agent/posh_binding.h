// Checks a plan against the senses and acts of its robot, before the robot moves.
#pragma once

#include "core/agent/posh_registry.h"
#include "core/posh/finding.h"

namespace usar::agent {

/// E303 for a plan without drives; E304 for each use of a name that the robot has not, with up to three similar ones;
/// E305 for a form that takes a primitive's name; E307 for a primitive used in the wrong way or with arguments that it
/// does not take. In the order of the text; empty: the plan can run.
posh::Findings checkBinding(const posh::Plan& plan, const PoshRegistry& registry);

/// Those of reading the text and of binding; the program, where there is no error.
struct PlanForRobot {
    posh::Findings findings;
    std::shared_ptr<const posh::Program> program;
};
PlanForRobot bindPlan(std::string_view text, const PoshRegistry& registry);

} // namespace usar::agent
