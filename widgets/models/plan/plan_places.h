// Converts places in a plan's text to positions in a QString, and finds the part of the drawn plan at a place; remarks
// about a text that are not errors.
#pragma once

#include <string_view>
#include <vector>

#include <QString>

#include "core/posh/model/plan.h"
#include "widgets/models/plan/plan_tree.h"

namespace usar::widgets {

/// Returns a plan's text as an editor shows it, with the same lines as its reader counts: CR LF ends one line; a lone
/// CR and other characters that Qt would take for line ends become blanks.
QString editorText(std::string_view plan_text);

/// A range of UTF-16 units within one line of that text.
struct TextRange {
    int start = 0;
    int length = 0;
    bool operator==(const TextRange&) const = default;
};

/// Converts a spot, which counts code points and bytes, to a range that stays within its line; at least one unit long
/// unless the line is empty. `line` is the text of the spot's line.
TextRange rangeOf(const posh::Spot& spot, const QString& line);
/// Column of a position in a line, in code points from 1.
int columnOf(const QString& line, int position);

/// The node whose text begins last at or before this place (line and column count from 1); none if there is none or the
/// plan was not read from text.
PlanNodeId nodeAtPlace(const PlanTree& tree, int line, int column);

/// A remark about a plan. Shown like a finding, but ranked below warnings; nothing needs to be fixed.
struct PlanNote {
    posh::Spot at;
    QString words; ///< worded like a finding: "4:3: note N501: …"
};

/// N501, at the keyword of the drive collection: the plan asks for real time, but runs on the robot's clock.
std::vector<PlanNote> notesOf(const posh::Plan& plan);

} // namespace usar::widgets
