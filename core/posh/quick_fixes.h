// Mends for what is wrong with a plan, ready to be put into its text.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/posh/finding.h"
#include "core/posh/token_splice.h"

namespace usar::posh {

/// What the robot offers to plans; empty where it is not known.
struct Vocabulary {
    std::vector<std::string> senses;
    std::vector<std::string> acts;
};

struct QuickFix {
    std::string title;         ///< what it does: "Write trigger", "Close 2 parentheses"
    std::vector<Splice> edits; ///< of the text that was checked, in order and apart
};

/// All that is wrong with a text; with binding to a robot it says more than the reader.
using PlanCheck = std::function<Findings(std::string_view text)>;

/// The likeliest first, at most eight. Each was tried: the finding is gone with it, and no other error has come. The
/// finding is one of those that `check` (without one: the reader) says of this text. Costs a reading for each mend that
/// is thought of: a dozen or so.
std::vector<QuickFix> quickFixes(std::string_view text, const Finding& finding, const Vocabulary& vocabulary = {},
                                 const PlanCheck& check = {});

std::string withFix(std::string_view text, const QuickFix& fix);

/// What changes one text into the other: one piece, as short as may be, beginning and ending between characters. Empty
/// for equal texts.
std::vector<Splice> difference(std::string_view before, std::string_view after);

} // namespace usar::posh
