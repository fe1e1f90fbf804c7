// What every edit of a plan's text does: read, change, write back with the layout kept, and look whether it is sound.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/posh/plan_edits.h"
#include "core/posh/plan_reader.h"
#include "core/posh/plan_writer.h"

namespace usar::posh {

/// Nothing is read from what has an error of characters or grammar; then no edit may touch it.
Result<PlanReading> readForEdit(std::string_view text);

/// The outcome, if the new text has no error that the old one had not.
Result<PlanEdit> checkedEdit(const PlanReading& before, std::string text, const PlanPart& part);

/// `change(Plan&)` gives a Result<PlanPart>: what to look at afterwards.
template <class Change>
Result<PlanEdit> changePlan(std::string_view text, Change&& change) {
    auto before = readForEdit(text);
    if (!before)
        return tl::unexpected(before.error());
    Plan plan = before->plan;
    const Result<PlanPart> part = change(plan);
    if (!part)
        return tl::unexpected(part.error());
    return checkedEdit(*before, writeKeepingLayout(text, plan), *part);
}

/// The same of a part that must be there.
inline tl::unexpected<Error> noSuchPart() {
    return failure("the plan has no such part", "", "choose another one");
}

inline Call& callIn(Plan& plan, const PlanPart& part) {
    return const_cast<Call&>(*callOf(plan, part)); // the plan is ours to change
}

/// The parameters that a call in `form` hands on are `needed` by a form that takes it over, with the defaults that
/// they have; `reference` calls that form and passes them.
void handOn(const Call& call, const Form& form, Call& reference, std::vector<Formal>& needed);

inline Call callNamed(std::string name) {
    return {{std::move(name), {}}, {}};
}

} // namespace usar::posh
