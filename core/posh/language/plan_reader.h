// Reads the text of a plan, in any of the dialects of POSH, and checks what does not depend on the robot.
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

/// Reads a plan from UTF-8 text and checks it as far as possible without a robot (see checkPlan). Accepts any bytes
/// and any depth of nesting. Takes time linear in the length of the text. A text longer than longest_plan_bytes gives
/// an empty plan and an error.
PlanReading readPlan(std::string_view text);

/// Returns the errors E301, E302 and E306 and the warnings about the plan as a whole, in no particular order. If the
/// text had errors, forms are missing from the plan; pass `is_whole` as false then to suppress findings about missing
/// and unused forms.
Findings checkPlan(const Plan& plan, bool is_whole = true);

/// Reads the operand of a sense, as a plan writes it: `nil`, `true`, `7`, `2.0`, `"text"`, `'red`, `red`. Returns
/// nullopt if the text is not exactly one value.
std::optional<Value> readValue(std::string_view text);

} // namespace usar::posh
