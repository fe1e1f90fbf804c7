// The steps that all edits of a plan's text share: read it, change the plan, write it back with its layout kept, and
// check the result.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/posh/edit/plan_edits.h"
#include "core/posh/language/plan_reader.h"
#include "core/posh/language/plan_writer.h"

namespace usar::posh {

/// Reads a text that is to be edited. Fails if it has an error in characters or grammar, because an edit would lose the
/// forms that have the errors.
Result<PlanReading> readForEdit(std::string_view text);

/// Returns the edit, or fails if the new text has more errors of any kind than the old one.
Result<PlanEdit> checkedEdit(const PlanReading& before, std::string text, const PlanPart& part);

/// Edits a text. `change(Plan&)` changes the plan and returns a Result<PlanPart>: the part to select after the edit.
template <class Change>
Result<PlanEdit> changePlan(std::string_view text, Change&& change) {
    auto before = readForEdit(text);
    if (!before)
        return tl::unexpected(before.error());
    Plan plan = before->plan;
    return change(plan).and_then(
        [&](const PlanPart& part) { return checkedEdit(*before, writeKeepingLayout(text, plan), part); });
}

/// The error for an edit of a part that does not exist.
inline tl::unexpected<Error> noSuchPart() {
    return failure("the plan has no such part", "", "choose another one");
}

/// These return what a part is or has, for changing it; the part must have it. The const_cast is sound, because the
/// caller owns the plan and may change it.
inline Call& callIn(Plan& plan, const PlanPart& part) {
    return const_cast<Call&>(*callOf(plan, part));
}
inline SenseTest& senseIn(Plan& plan, const PlanPart& part) {
    return const_cast<SenseTest&>(*senseOf(plan, part));
}
inline Member& memberIn(Plan& plan, const PlanPart& part) {
    return const_cast<Member&>(*memberOf(plan, part));
}

/// Returns a call of a new form and makes its name unique; an empty `name` is replaced by `fallback`. Fails if no form
/// can have that name.
Result<Call> referenceTo(const Plan& plan, std::string& name, const std::string& fallback);

/// Prepares moving `call` from `form` into a new form. Appends the parameters of `form` that the call uses, with their
/// defaults, to `needed` (the parameters of the new form), and appends arguments that pass them on to `reference` (the
/// call of the new form).
void handOn(const Call& call, const Form& form, Call& reference, std::vector<Formal>& needed);

/// Returns a call without arguments.
inline Call callNamed(std::string name) {
    return {{std::move(name)}};
}

inline Call doNothing() {
    return callNamed("doNothing");
}

/// Returns the built-in sense that never holds.
inline SenseTest never() {
    return {callNamed("fail")};
}

/// Returns a name without the module before its last dot.
inline std::string withoutModule(const std::string& name) {
    return name.substr(name.rfind('.') + 1);
}

/// Inserts an item before the one with this index; `index` may be the size of the list.
template <class Item>
void insertAt(std::vector<Item>& list, std::size_t index, Item item) {
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(index), std::move(item));
}

template <class Item>
void eraseAt(std::vector<Item>& list, std::size_t index) {
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
}

/// Inserts a form before the one with this index and returns it as a part.
inline PlanPart insertForm(Plan& plan, std::size_t index, Form form) {
    insertAt(plan.forms, index, std::move(form));
    return formPart(index);
}

} // namespace usar::posh
