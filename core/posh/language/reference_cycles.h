// The search for competences, patterns and adopts that contain themselves.
#pragma once

#include "core/posh/language/form_index.h"
#include "core/posh/model/finding.h"
#include "core/posh/model/plan.h"

namespace usar::posh {

/// Appends an error E302 for each reference that closes a cycle, even if the collection never reaches it. `index` must
/// be that of the plan.
void checkReferenceCycles(const Plan& plan, const FormIndex& index, Findings& findings);

} // namespace usar::posh
