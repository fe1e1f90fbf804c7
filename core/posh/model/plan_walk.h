// Reaches what forms of different kinds have in common; visits every call of a form and all comments of a plan.
#pragma once

#include <variant>

#include "core/posh/model/plan.h"

namespace usar::posh {

/// Returns what `get(form)` points to for the kinds of forms that have it, otherwise nullptr. `get` names one member:
/// `[](auto& form) -> decltype(&form.goal) { return &form.goal; }`.
/// The pointer is valid as long as the form is and its kind stays the same.
template <class Field, class AnyForm, class Get>
Field* fieldOf(AnyForm& form, Get get) {
    return std::visit(
        [&get](auto& any) -> Field* {
            if constexpr (requires { get(any); })
                return get(any);
            return nullptr;
        },
        form);
}

/// Calls `visit(call, is_sense)` for each call of a form: the senses of goals, triggers and steps, and the actions of
/// drives, elements, steps and adopts. `AnyForm` may be const; the calls are then const, too.
/// Within a member the trigger comes before the action.
template <class AnyForm, class Visit>
void forEachCall(AnyForm& form, Visit&& visit) {
    const auto visitSenses = [&visit](auto& senses) {
        for (auto& test : senses)
            visit(test.call, true);
    };
    const auto visitLevels = [&visit, &visitSenses](auto& levels) {
        for (auto& level : levels)
            for (auto& member : level) {
                visitSenses(member.trigger);
                visit(member.action, false);
            }
    };
    std::visit(
        [&](auto& any) {
            if constexpr (requires { any.goal; })
                visitSenses(any.goal);
            if constexpr (requires { any.levels; })
                visitLevels(any.levels);
            if constexpr (requires { any.adopted; })
                visit(any.adopted, false);
            if constexpr (requires { any.steps; })
                for (auto& step : any.steps) {
                    if (auto* const test = std::get_if<SenseTest>(&step))
                        visit(test->call, true);
                    else
                        visit(std::get<Call>(step), false);
                }
        },
        form);
}

/// Calls `visit` with the Remarks of the plan, its documentation, and each form and member. `AnyPlan` may be const; the
/// remarks are then const, too.
/// Members come right after their form.
template <class AnyPlan, class Visit>
void forEachRemarks(AnyPlan& plan, Visit&& visit) {
    visit(plan.remarks);
    if (plan.documentation)
        visit(plan.documentation->remarks);
    for (auto& form : plan.forms) {
        visit(remarksOf(form));
        if (auto* const levels = levelsIn(form))
            for (auto& level : *levels)
                for (auto& member : level)
                    visit(member.remarks);
    }
}

} // namespace usar::posh
