// What is allowed in a plan and yet is nearly always a mistake.
#pragma once

#include "core/posh/finding.h"
#include "core/posh/form_index.h"
#include "core/posh/plan.h"

namespace usar::posh {

/// Warnings W401 to W404 and W410 to W412.
void warnOfPlan(const Plan& plan, const FormIndex& index, bool is_whole, Findings& findings);

} // namespace usar::posh
