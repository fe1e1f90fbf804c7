// Edits of several neighboring parts at once.
#include <algorithm>

#include "core/posh/edit/plan_change.h"
#include "core/posh/edit/plan_phrase.h"

namespace usar::posh {

void handOn(const Call& call, const Form& form, Call& reference, std::vector<Formal>& needed) {
    for (const Argument& argument : call.arguments) {
        const auto* const variable = std::get_if<Variable>(&argument.value);
        const auto sameName = [variable](const Formal& formal) { return formal.variable.name == variable->name; };
        if (!variable || std::any_of(needed.begin(), needed.end(), sameName))
            continue;
        const auto& formals = formalsOf(form);
        const auto declared = std::find_if(formals.begin(), formals.end(), sameName);
        needed.push_back({{variable->name}, declared == formals.end() ? Literal() : declared->value});
        reference.arguments.push_back({variable->name, Variable{variable->name}});
    }
}

Result<Call> referenceTo(const Plan& plan, std::string& name, const std::string& fallback) {
    name = freeFormName(plan, name.empty() ? fallback : name);
    if (const auto good = checkName(name); !good)
        return tl::unexpected(good.error());
    return callNamed(name);
}

namespace {

struct Stretch {
    std::size_t begin = 0;
    std::size_t end = 0; ///< one past the last
};

/// Replaces a stretch of a list by the single item `instead` and returns the removed items.
template <class T>
std::vector<T> replaceStretch(std::vector<T>& list, const Stretch& stretch, T instead) {
    const auto begin = list.begin() + static_cast<std::ptrdiff_t>(stretch.begin);
    const auto end = list.begin() + static_cast<std::ptrdiff_t>(stretch.end);
    std::vector<T> taken(std::make_move_iterator(begin), std::make_move_iterator(end));
    *begin = std::move(instead);
    list.erase(begin + 1, end);
    return taken;
}

const Call& callOf(const Step& step) {
    const auto* const test = std::get_if<SenseTest>(&step);
    return test ? test->call : std::get<Call>(step);
}

Result<PlanPart> wrapSteps(Plan& plan, std::size_t form, const Stretch& stretch, FormKind kind, std::string name) {
    if (kind != FormKind::Ap)
        return failure("several steps are done one after the other", "", "wrap them in an action pattern");
    auto& pattern = std::get<Pattern>(plan.forms[form]);
    auto reference = referenceTo(plan, name, "do-" + withoutModule(callOf(pattern.steps[stretch.begin]).name.text));
    if (!reference)
        return tl::unexpected(reference.error());
    Pattern made{.name = {name}};
    for (std::size_t i = stretch.begin; i < stretch.end; ++i)
        handOn(callOf(pattern.steps[i]), plan.forms[form], *reference, made.formals);
    made.steps = replaceStretch(pattern.steps, stretch, Step(*std::move(reference)));
    return insertForm(plan, form, std::move(made));
}

Result<PlanPart> wrapLevels(Plan& plan, std::size_t form, const Stretch& stretch, FormKind kind, std::string name) {
    if (kind != FormKind::C)
        return failure("several of them are a choice", "", "wrap them in a competence");
    Levels& levels = *levelsIn(plan.forms[form]);
    auto reference = referenceTo(plan, name, "choose-" + levels[stretch.begin].front().name.text);
    if (!reference)
        return tl::unexpected(reference.error());
    Competence made{.name = {name}};
    for (std::size_t i = stretch.begin; i < stretch.end; ++i)
        for (const Member& member : levels[i]) {
            if (member.frequency)
                return failure("an element has no frequency", "the drive " + member.name.text,
                               "remove the frequency first");
            handOn(member.action, plan.forms[form], *reference, made.formals);
            for (const SenseTest& test : member.trigger)
                handOn(test.call, plan.forms[form], *reference, made.formals);
        }
    Member instead{.name = {freeMemberName(plan.forms[form], name)}, .action = *std::move(reference)};
    made.levels = replaceStretch(levels, stretch, Level{std::move(instead)});
    return insertForm(plan, form, std::move(made));
}

} // namespace

Result<PlanEdit> wrapParts(std::string_view text, const PlanPart& first, const PlanPart& last, FormKind kind,
                           std::string name) {
    return changePlan(text, [&](Plan& plan) -> Result<PlanPart> {
        if (first.form != last.form || !nameOf(plan, first) || !nameOf(plan, last))
            return noSuchPart();
        if (isStep(plan, first) && isStep(plan, last)) {
            const auto [begin, end] = std::minmax(first.index, last.index);
            return wrapSteps(plan, first.form, {begin, end + 1}, kind, std::move(name));
        }
        if (first.kind != PartKind::Member || last.kind != PartKind::Member)
            return noSuchPart();
        const auto [begin, end] = std::minmax(first.level, last.level);
        return wrapLevels(plan, first.form, {begin, end + 1}, kind, std::move(name));
    });
}

} // namespace usar::posh
