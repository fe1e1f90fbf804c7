// Small parts of a plan from what a person typed for them: into a box of the drawing, into a table.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/posh/plan.h"
#include "core/posh/plan_part.h"

namespace usar::posh {

/// `Distance 0.3 <` or `(Distance 0.3 <)`.
Result<SenseTest> readSensePhrase(std::string_view words);
/// `(Distance 0.3 <) (Loaded false)`; `nil` or nothing at all: none.
Result<Senses> readSensesPhrase(std::string_view words);
/// `DriveTo("depot", $speed=1.5)`.
Result<Call> readCallPhrase(std::string_view words);
/// `3`; nothing: no limit.
Result<std::optional<Literal>> readRetriesPhrase(std::string_view words);
/// `seconds 2` or `(seconds 2)`, with `rates_allowed` also `hz 5`, `pm 3` and `ticks 4`; nothing: no limit.
Result<std::optional<Interval>> readIntervalPhrase(std::string_view words, bool rates_allowed);

/// The other way round: `Distance 0.3 <`.
std::string phraseOf(const SenseTest& test);
/// Of the trigger of a member or the goal of a form: `(Distance 0.3 <) (Loaded false)`; empty for none.
std::string sensesPhrase(const Plan& plan, const PlanPart& owner);
/// Retries, frequency or time, as the functions above read them; empty for none.
std::string limitPhrase(const Plan& plan, const PlanPart& owner);

/// Whether a form, a drive or an element can have this name.
Result<void> checkNewName(std::string_view name);
/// Whether a sense or an act can: theirs may have dots.
Result<void> checkPrimitiveName(std::string_view name);

} // namespace usar::posh
