// Writes plans as text: in the canonical layout, or in the layout of the text that they were read from.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/posh/model/plan.h"

namespace usar::posh {

/// Writes a plan in the canonical layout: forms in their order, an indent of two blanks, one drive or element per line,
/// the text after their names aligned in one column, and comments and blank lines with the part they belong to. Reading
/// the text back gives an equal plan, which is then written as the same text.
std::string writePlan(const Plan& plan);

/// These write one form or the documentation like writePlan, without the comments above it. All lines but the first are
/// indented.
std::string writeForm(const Form& form);
std::string writeDocumentation(const Documentation& documentation);

/// Writes the lines of one level as writePlan does within its form, with a line end.
std::string writeLevel(const Levels& levels, std::size_t index);

/// Writes a `plan` that was read from `text` and then edited. Keeps every byte that was not edited: the other forms,
/// the unchanged levels of an edited form, and the words around a change. Falls back to writePlan if `text` has errors
/// in characters or grammar, if the comments of the whole plan changed, or if keeping the layout would change the
/// plan's meaning or lose comments.
std::string writeKeepingLayout(std::string_view text, const Plan& plan);

} // namespace usar::posh
