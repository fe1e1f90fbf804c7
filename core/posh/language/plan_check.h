// Checks of a plan that do not depend on the robot: names, references, parameters, and likely mistakes.
#pragma once

#include "core/posh/model/finding.h"
#include "core/posh/model/plan.h"

namespace usar::posh {

/// Returns the errors E301, E302 and E306 and the warnings about the plan as a whole, in no particular order. If the
/// text had errors, forms are missing from the plan; pass `is_whole` as false then to suppress findings about missing
/// and unused forms.
Findings checkPlan(const Plan& plan, bool is_whole = true);

} // namespace usar::posh
