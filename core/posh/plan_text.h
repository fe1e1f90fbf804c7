// The parts of a form as text on one line, as the canonical layout has them. Each appends to `out`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/posh/plan.h"

namespace usar::posh {

void appendLiteral(std::string& out, const Literal& literal);
void appendCall(std::string& out, const Call& call);
void appendTest(std::string& out, const SenseTest& test);
/// `((a) (b 3 <))`; `nil` where there are none.
void appendSenses(std::string& out, const Senses& senses);
/// ` vars($a=1)`, with the blank before it; nothing where there are none. The same holds for what follows.
void appendFormals(std::string& out, const std::vector<Formal>& formals);
void appendInterval(std::string& out, const std::optional<Interval>& interval);
void appendGoal(std::string& out, const Senses& goal);
void appendComment(std::string& out, const std::optional<Literal>& comment);

/// From `(` to `)`. What follows the name begins at least `name_width` columns behind the parenthesis.
void appendMember(std::string& out, const Drive& drive, std::size_t name_width = 0);
void appendMember(std::string& out, const Element& element, std::size_t name_width = 0);

/// A comment that a program made gets its mark, and stays on its line.
std::string commentText(std::string_view remark);

/// The keyword as written, or that of the kind should a program have changed it.
std::string keywordText(const Collection& collection);

} // namespace usar::posh
