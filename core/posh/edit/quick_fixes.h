// Quick fixes for errors and warnings in a plan, ready to be applied to its text.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/posh/language/token_splice.h"
#include "core/posh/model/finding.h"

namespace usar::posh {

/// The names that the robot offers to plans; empty if they are not known.
struct Vocabulary {
    std::vector<std::string> senses;
    std::vector<std::string> acts;
};

struct QuickFix {
    std::string title;         ///< describes the fix: "Write trigger", "Close 2 parentheses"
    std::vector<Splice> edits; ///< changes of the text that was checked, in order and without overlap
};

/// Returns all errors and warnings of a text. A check that also binds the plan to a robot finds more than readPlan
/// does.
using PlanCheck = std::function<Findings(std::string_view text)>;

/// Returns at most eight fixes, the likeliest first. Each has been tried: it removes the finding and causes no new
/// error, although a form that becomes readable may show errors that it already had. The finding must be one that
/// `check`, or readPlan if `check` is empty, returned for this text. Reads the text again for each fix that is
/// considered, about a dozen times.
std::vector<QuickFix> quickFixes(std::string_view text, const Finding& finding, const Vocabulary& vocabulary = {},
                                 const PlanCheck& check = {});

/// Applies a fix to the text that it was made for.
std::string withFix(std::string_view text, const QuickFix& fix);

/// Returns the shortest single splice that turns one text into the other and does not split a UTF-8 character; an empty
/// list for equal texts.
std::vector<Splice> difference(std::string_view before, std::string_view after);

} // namespace usar::posh
