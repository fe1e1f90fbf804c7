// Competences, patterns and adopts that contain themselves.
#pragma once

#include "core/posh/finding.h"
#include "core/posh/form_index.h"
#include "core/posh/plan.h"

namespace usar::posh {

/// One E302 for each reference that closes a cycle, reachable or not.
void checkReferenceCycles(const Plan& plan, const FormIndex& index, Findings& findings);

} // namespace usar::posh
