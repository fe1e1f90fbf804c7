// Places in a plan's text: where they are in a string of Qt, and which part of the drawn plan stands there.
#pragma once

#include <string_view>

#include <QString>

#include "core/posh/plan.h"
#include "widgets/models/plan_tree.h"

namespace usar::widgets {

/// A plan's text as an editor shows it, with the same lines as its reader counts: CR LF is one end of a line, a lone CR
/// and what else Qt would take for one are blanks.
QString editorText(std::string_view plan_text);

/// UTF-16 units in one line of that text.
struct TextRange {
    int start = 0;
    int length = 0;
    bool operator==(const TextRange&) const = default;
};

/// A spot counts code points and bytes; the range stays in its line and is at least one unit long where the line has
/// one. `line` is the text of the spot's line.
TextRange rangeOf(const posh::Spot& spot, const QString& line);
/// The column (of code points, from 1) of a place in a line.
int columnOf(const QString& line, int position);

/// What begins last at or before this place, as the text reads; -1 where nothing does, or the plan was not read from a
/// text.
int nodeAtPlace(const PlanTree& tree, int line, int column);

} // namespace usar::widgets
