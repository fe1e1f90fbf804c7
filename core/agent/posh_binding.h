// Checks a plan against the senses and acts of its robot, before the robot moves.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/agent/posh_primitive.h"
#include "core/base/result.h"
#include "core/posh/finding.h"
#include "core/posh/program.h"

namespace usar::agent {

/// E303 for a plan without drives; E304 for each use of a name that the robot has not, with up to three similar ones;
/// E305 for a form that takes a primitive's name; E307 for a primitive used in the wrong way or with arguments that it
/// does not take. In the order of the text; empty: the plan can run. No robot need be there: descriptions are enough.
posh::Findings checkBinding(const posh::Plan& plan, const std::vector<PrimitiveDescription>& primitives);

/// Those of reading the text and of binding; the program, where there is no error.
struct PlanForRobot {
    posh::Findings findings;
    std::shared_ptr<const posh::Program> program;
};
PlanForRobot bindPlan(std::string_view text, const std::vector<PrimitiveDescription>& primitives);

/// A note where the plan asks for real time: it runs by the robot's clock as any other. Else empty.
std::string clockRemark(const posh::Plan& plan);

/// One error that lists all errors among the findings.
Error planRefusal(const std::string& plan_name, const posh::Findings& findings);

} // namespace usar::agent
