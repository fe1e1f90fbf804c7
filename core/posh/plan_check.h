// What can be said of a plan without knowing its robot: names, references, parameters, and what looks like a mistake.
#pragma once

#include "core/posh/finding.h"
#include "core/posh/plan.h"

namespace usar::posh {

/// Errors E301, E302, E306 and the warnings of the plan as a whole, in no particular order. Where the text had errors
/// the plan is not whole (`is_whole` false): what is missing is then not complained of.
Findings checkPlan(const Plan& plan, bool is_whole = true);

} // namespace usar::posh
