// Checks of a plan that do not depend on the robot: names, references, parameters, and likely mistakes.
#pragma once

#include "core/posh/language/form_index.h"
#include "core/posh/model/finding.h"
#include "core/posh/model/plan.h"

namespace usar::posh {

/// Returns the errors E301, E302 and E306 and the warnings about the plan as a whole, in no particular order. If the
/// text had errors, forms are missing from the plan; pass `is_whole` as false then to suppress findings about missing
/// and unused forms.
Findings checkPlan(const Plan& plan, bool is_whole = true);

// The parts of checkPlan. `index` must be that of the plan; each appends its findings.

/// Appends an error E302 for each reference that closes a cycle, even if the collection never reaches it.
void checkReferenceCycles(const Plan& plan, const FormIndex& index, Findings& findings);
/// Appends the warnings W401 to W404 and W410 to W412; without W401 and W404 if `is_whole` is false.
void warnOfPlan(const Plan& plan, const FormIndex& index, bool is_whole, Findings& findings);

} // namespace usar::posh
