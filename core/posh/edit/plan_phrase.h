// Parses and formats small parts of a plan, as the user types them into the drawing or a table.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/posh/edit/plan_part.h"
#include "core/posh/model/plan.h"

namespace usar::posh {

/// Reads `Distance 0.3 <` or `(Distance 0.3 <)`.
Result<SenseTest> readSensePhrase(std::string_view words);
/// Reads `(Distance 0.3 <) (Loaded false)`. `nil` and an empty text give an empty list.
Result<Senses> readSensesPhrase(std::string_view words);
/// Reads `DriveTo("depot", $speed=1.5)`.
Result<Call> readCallPhrase(std::string_view words);
/// Reads a whole number, `3`. An empty text gives nullopt: no limit.
Result<std::optional<Literal>> readRetriesPhrase(std::string_view words);
/// Reads `seconds 2` or `(seconds 2)`, with `rates_allowed` also `hz 5`, `pm 3` and `ticks 4`. An empty text gives
/// nullopt: no limit.
Result<std::optional<Interval>> readIntervalPhrase(std::string_view words, bool rates_allowed);

/// Formats a sense as readSensePhrase reads it: `Distance 0.3 <`.
std::string phraseOf(const SenseTest& test);
/// Formats the trigger of a member or the goal of a form: `(Distance 0.3 <) (Loaded false)`; empty if it has no senses.
std::string sensesPhrase(const Plan& plan, const PlanPart& owner);
/// Formats the retries, frequency or time limit of a part as the functions above read them; empty if it has none.
std::string limitPhrase(const Plan& plan, const PlanPart& owner);

/// Fails if a form, a drive or an element cannot have this name. With `dots_allowed`, the name may be that of a sense
/// or an act, which can have dots.
Result<void> checkName(std::string_view name, bool dots_allowed = false);

} // namespace usar::posh
