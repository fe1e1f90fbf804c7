// Warnings about a plan: what is allowed but nearly always a mistake.
#pragma once

#include "core/posh/language/form_index.h"
#include "core/posh/model/finding.h"
#include "core/posh/model/plan.h"

namespace usar::posh {

/// Appends the warnings W401 to W404 and W410 to W412. `index` must be that of the plan. If `is_whole` is false, forms
/// are missing from the plan, and the warnings W401 and W404 are left out.
void warnOfPlan(const Plan& plan, const FormIndex& index, bool is_whole, Findings& findings);

} // namespace usar::posh
