// Plans as text: in the canonical layout, or in the layout of the text they were read from.
#pragma once

#include <string>
#include <string_view>

#include "core/posh/plan.h"

namespace usar::posh {

/// Canonical: forms in their order, two blanks of indent, a drive or element a line, what follows their names in one
/// column, comments and blank lines where they belong. Reads back to an equal plan, and then writes the same text.
std::string writePlan(const Plan& plan);

/// One form or the documentation as writePlan has it, without the remarks above it. Lines but the first are indented.
std::string writeForm(const Form& form);
std::string writeDocumentation(const Documentation& documentation);

/// `plan` was read from `text` and then edited. Keeps every byte of what was not edited: of a form in which only drives
/// or elements changed, the others; else the other forms. Where `text` is no plan without errors, or nothing of it
/// remains, this is writePlan.
std::string writeKeepingLayout(std::string_view text, const Plan& plan);

} // namespace usar::posh
