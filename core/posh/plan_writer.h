// Plans as text: in the canonical layout, or in the layout of the text they were read from.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/posh/plan.h"

namespace usar::posh {

/// Canonical: forms in their order, two blanks of indent, a drive or element a line, what follows their names in one
/// column, comments and blank lines where they belong. Reads back to an equal plan, and then writes the same text.
std::string writePlan(const Plan& plan);

/// One form or the documentation as writePlan has it, without the remarks above it. Lines but the first are indented.
std::string writeForm(const Form& form);
std::string writeDocumentation(const Documentation& documentation);

/// The lines of one level, as they stand in its form.
std::string writeLevel(const std::vector<DriveLevel>& levels, std::size_t index);
std::string writeLevel(const std::vector<ElementLevel>& levels, std::size_t index);

/// `plan` was read from `text` and then edited. Keeps every byte of what was not edited: the other forms, and of an
/// edited one the levels that are as they were; within what changed, the words around the change. Where `text` cannot
/// be read, or nothing of it remains, this is writePlan.
std::string writeKeepingLayout(std::string_view text, const Plan& plan);

} // namespace usar::posh
