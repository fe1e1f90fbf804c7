// Quick fixes for a plan that can be read but has other errors or warnings, or does not fit its robot.
#include <algorithm>

#include "core/posh/edit/fix_finder.h"
#include "core/posh/edit/plan_change.h"
#include "core/posh/language/form_index.h"
#include "core/posh/model/plan_walk.h"

namespace usar::posh {

namespace {

/// Removes the argument that begins at this byte of the text. Returns false if there is none.
bool eraseArgument(Plan& plan, std::size_t offset) {
    bool erased = false;
    for (Form& form : plan.forms)
        forEachCall(form, [&](Call& call, bool) {
            erased = erased || std::erase_if(call.arguments, [offset](const Argument& argument) {
                                   return argument.at.line > 0 && argument.at.offset == offset;
                               }) > 0;
        });
    return erased;
}

/// Adds a parameter with this name and default to a form.
Result<PlanEdit> declare(std::string_view text, std::size_t form, const std::string& name, const Literal& value) {
    return changePlan(text, [&](Plan& plan) -> Result<PlanPart> {
        auto* const formals = fieldOf<std::vector<Formal>>(
            plan.forms[form], [](auto& any) -> decltype(&any.formals) { return &any.formals; });
        if (!formals)
            return noSuchPart();
        formals->push_back({{name}, value});
        return formPart(form);
    });
}

/// Returns the call for the drive of a new collection: the first form that no other form calls, or `doNothing`.
Call mainCallOf(const Plan& plan) {
    const FormIndex index(plan);
    for (std::size_t i = 0; i < plan.forms.size(); ++i) {
        if (std::ranges::find(index.references(), i, &Reference::target) == index.references().end())
            return callNamed(nameOf(plan.forms[i]).text);
    }
    return doNothing();
}

} // namespace

/// Fixes what has one obvious remedy.
void FixFinder::fixSimply() {
    if (!part_)
        return;
    if (finding_.code == Code::ReferenceCycle)
        add("Do nothing here", replaceCall(text_, *part_, doNothing()));
    else if (finding_.code == Code::NeverUsed)
        add("Remove it", removePart(text_, *part_));
    else if (finding_.code == Code::NoElements)
        add("Add an element that does nothing", addMember(text_, {part_->form}, doNothing(), {}, "idle"));
    else
        add("Remove the number", setLimit(text_, *part_, ""));
}

void FixFinder::fixDuplicate() {
    if (!part_)
        return;
    const std::string old = nameOf(reading_.plan, *part_)->text;
    const bool is_form = part_->kind == PartKind::Whole;
    const std::string name =
        is_form ? freeFormName(reading_.plan, old) : freeMemberName(reading_.plan.forms[part_->form], old);
    add("Name it " + name, renamePart(text_, *part_, name));
    add("Remove it", removePart(text_, *part_));
}

/// Fixes a name that the robot does not have: by a similar one that exists, or by a new pattern with that name.
void FixFinder::fixUnknownName() {
    if (!part_ || !callOf(reading_.plan, *part_))
        return;
    const bool is_sense = part_->kind == PartKind::Sense;
    std::vector<std::string> known = is_sense ? vocabulary_.senses : vocabulary_.acts;
    if (!is_sense)
        for (const Form& form : reading_.plan.forms)
            if (!std::holds_alternative<Collection>(form))
                known.push_back(nameOf(form).text);
    const std::string name(nameOf(reading_.plan, *part_)->text);
    const std::size_t before = fixes_.size();
    writeNearest(known, std::max<std::size_t>(3, name.size() / 2), 3);
    const std::size_t uses = usagesOf(reading_.plan, *part_).size();
    if (uses > 1 && fixes_.size() > before) {
        const std::string nearest = fixes_[before].edits.front().text;
        if (!FormIndex(reading_.plan).find(nearest))
            add("Write " + nearest + " everywhere (" + std::to_string(uses) + " places)",
                renamePart(text_, *part_, nearest));
    }
    if (is_sense)
        return add("Remove this sense", removePart(text_, *part_));
    add("Do nothing here", replaceCall(text_, *part_, doNothing()));
    if (!name.empty()) // Only calls use the name, and they are meant to call the new pattern
        add("Make a pattern " + name, changePlan(text_, [&](Plan& plan) -> Result<PlanPart> {
                return insertForm(plan, part_->form, Pattern{.name = {name}, .steps = {doNothing()}});
            }));
}

void FixFinder::fixWrongUse() {
    const Call* const call = part_ ? callOf(reading_.plan, *part_) : nullptr;
    if (!call)
        return;
    if (!call->arguments.empty())
        add("Remove the arguments", changePlan(text_, [&](Plan& plan) -> Result<PlanPart> {
                callIn(plan, *part_).arguments.clear();
                return *part_;
            }));
    if (call->arguments.size() > 1)
        add("Remove the last argument", changePlan(text_, [&](Plan& plan) -> Result<PlanPart> {
                callIn(plan, *part_).arguments.pop_back();
                return *part_;
            }));
    fixUnknownName();
}

void FixFinder::fixVariable() {
    const std::string name(found().substr(std::min<std::size_t>(1, found().size())));
    if (!part_ || name.empty())
        return;
    std::vector<std::string> known;
    for (const Formal& formal : formalsOf(reading_.plan.forms[part_->form]))
        known.push_back('$' + formal.variable.name);
    writeNearest(known, 4, 2);
    add("Declare $" + name, declare(text_, part_->form, name, {std::int64_t{0}, "0"}));
    replaceFound("0");
}

void FixFinder::fixUndeclared() {
    add("Remove the argument", changePlan(text_, [this](Plan& plan) -> Result<PlanPart> {
            if (!eraseArgument(plan, finding_.at.offset))
                return noSuchPart();
            return PlanPart();
        }));
    const FormIndex index(reading_.plan);
    for (const Reference& reference : index.references())
        for (const Argument& argument : reference.call->arguments) {
            if (argument.at.offset != finding_.at.offset)
                continue;
            const std::string name = argument.name.empty()
                                         ? "x" + std::to_string(index.formals(reference.target).size() + 1)
                                         : argument.name;
            const auto* const literal = std::get_if<Literal>(&argument.value);
            add("Declare $" + name,
                declare(text_, reference.target, name, literal ? *literal : Literal{std::int64_t{0}, "0"}));
        }
}

void FixFinder::fixUnreached() {
    if (!part_ || part_->kind != PartKind::Member)
        return;
    for (const NamedPart& other : partsOf(reading_.plan)) {
        const PlanPart& candidate = other.part;
        const bool is_beside = candidate.kind == PartKind::Member && candidate.form == part_->form;
        const Member* const member = is_beside ? memberOf(reading_.plan, candidate) : nullptr;
        if (!member || !member->trigger.empty() || retryLimit(*member))
            continue;
        add("Move " + inQuotes(other.name->text) + " to the end",
            moveMember(text_, candidate, {part_->form, std::size_t(-1)}));
        add("Give " + inQuotes(other.name->text) + " a trigger that never holds",
            setSenses(text_, candidate, {never()}));
        break;
    }
    add("Remove " + inQuotes(nameOf(reading_.plan, *part_)->text), removePart(text_, *part_));
}

void FixFinder::fixFindingNothing() {
    const auto* const competence = part_ ? std::get_if<Competence>(&reading_.plan.forms[part_->form]) : nullptr;
    if (!competence || competence->levels.empty())
        return;
    const std::string name = freeMemberName(*competence, "otherwise");
    add("Add a last element that does nothing",
        addMember(text_, {part_->form, std::size_t(-1)}, doNothing(), {}, name));
    const std::size_t last = competence->levels.size() - 1;
    add("Remove the trigger of the last element",
        setSenses(text_, memberPart(part_->form, last, competence->levels[last].size() - 1), {}));
    add("Add a goal that is never reached", setSenses(text_, formPart(part_->form), {never()}));
}

/// Renames a form or member whose name is misleading or also a name of the robot.
void FixFinder::fixName() {
    const std::string old(found());
    if (!part_ || !nameOf(reading_.plan, *part_) || old.empty())
        return;
    const bool has_digit = finding_.code == Code::NameStartsWithDigit;
    const std::string wanted = has_digit                              ? "n" + old
                               : finding_.code == Code::KeywordAsName ? "my-" + old
                                                                      : old + "-plan";
    const std::string name = part_->kind == PartKind::Member ? freeMemberName(reading_.plan.forms[part_->form], wanted)
                                                             : freeFormName(reading_.plan, wanted);
    add("Name it " + name, renamePart(text_, *part_, name));
}

void FixFinder::fixMissingCollection() {
    const std::string name = freeFormName(reading_.plan, "life");
    add("Add a drive collection", addForm(text_, FormKind::Dc, name, mainCallOf(reading_.plan)));
}

} // namespace usar::posh
