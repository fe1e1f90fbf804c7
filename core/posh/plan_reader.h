// Reads the text of a plan, in any of the dialects of POSH.
#pragma once

#include <optional>
#include <string_view>

#include "core/posh/finding.h"
#include "core/posh/plan.h"

namespace usar::posh {

/// What could be read, and what is wrong with the text. A form with an error is left out of the plan.
struct PlanReading {
    Plan plan;
    Findings findings; ///< those of the text in its order, then those of the plan as a whole in the order of the text
};

/// UTF-8; any bytes are allowed, and no depth of nesting is too great. Linear in the length of the text. Includes the
/// static checks that need no robot (see plan_check.h).
PlanReading readPlan(std::string_view text);

/// The value of a sense's operand, as a plan writes it: `nil`, `true`, `7`, `2.0`, `"text"`, `'red`, `red`. Nothing
/// where it is none, or more than one.
std::optional<Value> readValue(std::string_view text);

} // namespace usar::posh
