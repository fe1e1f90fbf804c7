// Writes plans and their parts as text: in the canonical layout, or in the layout of the text that they were read from.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

// The parts of a form on one line, in the canonical layout. The functions whose names begin with append append to
// `out`.

void appendLiteral(std::string& out, const Literal& literal);
void appendCall(std::string& out, const Call& call);
void appendTest(std::string& out, const SenseTest& test);
void appendStep(std::string& out, const Step& step);
/// Appends `((a) (b 3 <))`, or `nil` if there are no senses.
void appendSenses(std::string& out, const Senses& senses);
/// Appends ` vars($a=1)` with the leading blank, or nothing if there are no parameters. The three functions below do
/// the same: they begin with a blank and append nothing for an absent part.
void appendFormals(std::string& out, const std::vector<Formal>& formals);
void appendInterval(std::string& out, const std::optional<Interval>& interval);
void appendComment(std::string& out, const std::optional<Literal>& comment);

/// Appends a drive or an element from `(` to `)`. The text after the name begins at least `name_width` columns after
/// the opening parenthesis.
void appendMember(std::string& out, const Member& member, std::size_t name_width = 0);

/// Returns a `;` comment as it is written: on one line, and with the mark added if it has none. An empty text stays
/// empty.
std::string commentText(std::string_view remark);

/// Returns the keyword as written, or that of the kind if the two no longer agree because the kind was changed.
std::string keywordText(const Collection& collection);

/// These return the start of a form, up to its levels: `(C name vars($a=1) (seconds 2) (goal ((b)))`, `(DC name`.
std::string headText(const Competence& competence);
std::string headText(const Collection& collection);

} // namespace usar::posh
