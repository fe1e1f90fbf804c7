// Reads the text of a plan, in any of the dialects of POSH.
#pragma once

#include <optional>
#include <string_view>

#include "core/posh/model/finding.h"
#include "core/posh/model/plan.h"

namespace usar::posh {

/// The forms that could be read, and the errors and warnings of the text. A form with an error is missing from the
/// plan.
struct PlanReading {
    Plan plan;
    Findings findings; ///< those of characters and grammar, then those of checkPlan, each in the order of the text
};

/// Reads a plan from UTF-8 text and checks it as far as possible without a robot (see plan_check.h). Accepts any bytes
/// and any depth of nesting. Takes time linear in the length of the text. A text longer than longest_plan_bytes gives
/// an empty plan and an error.
PlanReading readPlan(std::string_view text);

/// Reads the operand of a sense, as a plan writes it: `nil`, `true`, `7`, `2.0`, `"text"`, `'red`, `red`. Returns
/// nullopt if the text is not exactly one value.
std::optional<Value> readValue(std::string_view text);

} // namespace usar::posh
