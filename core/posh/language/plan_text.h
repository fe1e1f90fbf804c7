// Formats the parts of a form on one line, in the canonical layout. Each function appends to `out`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/posh/model/plan.h"

namespace usar::posh {

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
void appendGoal(std::string& out, const Senses& goal);
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
