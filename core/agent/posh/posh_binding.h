// Checks a plan against the senses and acts of its robot before the robot moves.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/agent/posh/posh_primitive.h"
#include "core/base/result.h"
#include "core/posh/model/finding.h"
#include "core/posh/run/program.h"

namespace usar::agent {

/// Reports E303 for a plan without drives, E304 for each use of a name that the robot does not have (with up to three
/// similar names), E305 for a form with the name of a primitive, and E307 for a primitive used in the wrong way or with
/// unsuitable arguments. Findings are in the order of the text; if there are none, the plan can run. Needs no robot,
/// only the descriptions of its primitives.
posh::Findings checkBinding(const posh::Plan& plan, const std::vector<PrimitiveDescription>& primitives);

/// The findings of reading the text and of checking it against the robot, and the program; nullptr if there are errors.
struct PlanForRobot {
    posh::Findings findings;
    std::shared_ptr<const posh::Program> program;
};
/// Reads, checks and compiles a plan.
PlanForRobot bindPlan(std::string_view text, const std::vector<PrimitiveDescription>& primitives);

/// A note for the user if the plan asks for real time, because it runs on the robot's clock like any other; else empty.
std::string clockRemark(const posh::Plan& plan);

/// A single error that lists all errors among the findings.
Error planRefusal(const std::string& plan_name, const posh::Findings& findings);

} // namespace usar::agent
