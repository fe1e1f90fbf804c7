// Edits that add, remove and change parts of a plan.
#include <algorithm>

#include "core/posh/edit/plan_change.h"
#include "core/posh/edit/plan_phrase.h"
#include "core/posh/language/form_index.h"
#include "core/posh/model/literal.h"
#include "core/posh/model/plan_walk.h"

namespace usar::posh {

namespace {

/// Returns a field of a member or what `get` returns for a form (see fieldOf); nullptr if the part does not exist or
/// cannot have it.
template <class Field, class Get>
Field* fieldIn(Plan& plan, const PlanPart& owner, Field Member::*field, Get get) {
    if (!nameOf(plan, owner))
        return nullptr;
    if (owner.kind == PartKind::Whole)
        return fieldOf<Field>(plan.forms[owner.form], get);
    return owner.kind == PartKind::Member ? &(memberIn(plan, owner).*field) : nullptr;
}

/// Returns the trigger of a member or the goal of a form.
Senses* sensesIn(Plan& plan, const PlanPart& owner) {
    return fieldIn(plan, owner, &Member::trigger, [](auto& form) -> decltype(&form.goal) { return &form.goal; });
}

Form madeForm(FormKind kind, const std::string& name, std::vector<Formal> formals, const Call& content) {
    switch (kind) {
    case FormKind::C: {
        Member element{.name = {withoutModule(content.name.text)}, .action = content};
        return Competence{.name = {name}, .formals = std::move(formals), .levels = {{std::move(element)}}};
    }
    case FormKind::Ap:
        return Pattern{.name = {name}, .formals = std::move(formals), .steps = {content}};
    case FormKind::Ad:
        return Adopt{.name = {name}, .formals = std::move(formals), .goal = {never()}, .adopted = content};
    case FormKind::Dc:
        break;
    }
    return Collection{.name = {name}, .levels = {{Member{.name = {"work"}, .action = content}}}};
}

/// Returns the index before the collection, so that the new form precedes its caller, or the end if there is none.
std::size_t placeForNewForm(const Plan& plan) {
    const auto found =
        std::ranges::find_if(plan.forms, [](const Form& form) { return std::holds_alternative<Collection>(form); });
    return static_cast<std::size_t>(found - plan.forms.begin());
}

std::string placesOf(const Plan& plan, const std::vector<PlanPart>& parts) {
    std::string text;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (i == 3)
            return text + ", …";
        const Spot& at = nameOf(plan, parts[i])->at;
        text += (text.empty() ? "line " : ", ") + std::to_string(at.line);
    }
    return text;
}

Result<PlanPart> removeForm(Plan& plan, const PlanPart& part) {
    std::vector<PlanPart> callers = usagesOf(plan, part);
    std::erase(callers, part);
    if (!callers.empty())
        return failure("it is called in " + placesOf(plan, callers), describe(plan, part),
                       "remove the calls first, or replace them with something else");
    eraseAt(plan.forms, part.form);
    return formPart(part.form == 0 ? 0 : part.form - 1);
}

Result<PlanPart> removeMember(Plan& plan, const PlanPart& part) {
    Form& form = plan.forms[part.form];
    Levels& levels = *levelsIn(form);
    Level& level = levels[part.level];
    if (levels.size() == 1 && level.size() == 1 && std::holds_alternative<Collection>(form))
        return failure("it is the last drive of the plan", describe(plan, part), "add another one first");
    eraseAt(level, part.member);
    if (level.empty())
        eraseAt(levels, part.level);
    return formPart(part.form);
}

Result<PlanPart> removeStep(Plan& plan, const PlanPart& part) {
    auto& steps = std::get<Pattern>(plan.forms[part.form]).steps;
    if (steps.size() == 1)
        return failure("it is the last step of its pattern", describe(plan, part), "add another one first");
    eraseAt(steps, part.index);
    return formPart(part.form);
}

/// Returns a copy that is not in the text yet and has no comments; those belong to the original.
template <class Kind>
Kind copyNamed(const Kind& original, std::string name) {
    Kind copy = original;
    copy.name = {std::move(name), {}};
    copy.remarks = {};
    copy.at = {};
    return copy;
}

/// Returns the steps that can replace a call of the form; nullopt if that would change the meaning of the plan.
std::optional<std::vector<Step>> contentOf(const Form& form) {
    if (!formalsOf(form).empty())
        return std::nullopt;
    if (const auto* const pattern = std::get_if<Pattern>(&form); pattern && !pattern->time_limit)
        return pattern->steps;
    const auto* const competence = std::get_if<Competence>(&form);
    if (!competence || competence->time_limit || !competence->goal.empty() || competence->levels.size() != 1 ||
        competence->levels[0].size() != 1)
        return std::nullopt;
    const Member& only = competence->levels[0][0];
    return only.trigger.empty() && !only.retries ? std::optional(std::vector<Step>{only.action}) : std::nullopt;
}

bool hasRemarks(const Form& form) {
    const Remarks& remarks = remarksOf(form);
    const auto* const comment = fieldOf<const std::optional<Literal>>(
        form, [](const auto& any) -> decltype(&any.comment) { return &any.comment; });
    return !remarks.beside.empty() || !std::ranges::all_of(remarks.above, &std::string::empty) || (comment && *comment);
}

} // namespace

Result<PlanEdit> addSense(std::string_view text, const PlanPart& owner, const SenseTest& test) {
    return changePlan(text, [&](Plan& plan) -> Result<PlanPart> {
        Senses* const senses = sensesIn(plan, owner);
        if (!senses)
            return failure("it cannot have senses", describe(plan, owner),
                           "choose a drive, an element or a form with a goal");
        senses->push_back(test);
        PlanPart part = owner;
        part.in_member = owner.kind == PartKind::Member;
        part.kind = PartKind::Sense;
        part.index = senses->size() - 1;
        return part;
    });
}

Result<PlanEdit> addForm(std::string_view text, FormKind kind, const std::string& name, const Call& content) {
    return changePlan(text, [&](Plan& plan) -> Result<PlanPart> {
        if (const auto good = checkName(name); !good)
            return tl::unexpected(good.error());
        const bool is_collection = kind == FormKind::Dc;
        if (is_collection && collectionOf(plan))
            return failure("a plan has one drive collection only", inQuotes(name), "add a drive to it");
        if (!is_collection && freeFormName(plan, name) != name)
            return failure("the plan already uses this name", inQuotes(name), "choose another name");
        return insertForm(plan, placeForNewForm(plan), madeForm(kind, name, {}, content));
    });
}

Result<PlanEdit> duplicatePart(std::string_view text, const PlanPart& part) {
    return changePlan(text, [&](Plan& plan) -> Result<PlanPart> {
        if (!nameOf(plan, part))
            return noSuchPart();
        Form& form = plan.forms[part.form];
        if (isStep(plan, part)) {
            auto& steps = std::get<Pattern>(form).steps;
            insertAt(steps, part.index, steps[part.index]);
            PlanPart copy = part;
            ++copy.index;
            return copy;
        }
        if (part.kind == PartKind::Whole) {
            if (std::holds_alternative<Collection>(form))
                return failure("a plan has one drive collection only", describe(plan, part), "duplicate a drive");
            const std::string name = freeFormName(plan, nameOf(form).text);
            Form copy = std::visit([&name](const auto& any) -> Form { return copyNamed(any, name); }, form);
            return insertForm(plan, part.form + 1, std::move(copy));
        }
        if (part.kind != PartKind::Member)
            return failure("only forms, drives, elements and steps can be duplicated", describe(plan, part));
        const std::string name = freeMemberName(form, nameOf(plan, part)->text);
        insertAt(*levelsIn(form), part.level + 1, Level{copyNamed(memberIn(plan, part), name)});
        return memberPart(part.form, part.level + 1, 0);
    });
}

Result<PlanEdit> removePart(std::string_view text, const PlanPart& part) {
    return changePlan(text, [&](Plan& plan) -> Result<PlanPart> {
        if (!nameOf(plan, part))
            return noSuchPart();
        if (isStep(plan, part))
            return removeStep(plan, part);
        if (part.kind == PartKind::Whole)
            return removeForm(plan, part);
        if (part.kind == PartKind::Member)
            return removeMember(plan, part);
        if (part.kind == PartKind::Action) {
            callIn(plan, part) = doNothing();
            return part;
        }
        eraseAt(*sensesIn(plan, ownerOf(part)), part.index);
        return ownerOf(part);
    });
}

Result<PlanEdit> replaceCall(std::string_view text, const PlanPart& part, const Call& call) {
    return changePlan(text, [&](Plan& plan) -> Result<PlanPart> {
        if (part.kind != PartKind::Action || !callOf(plan, part))
            return noSuchPart();
        callIn(plan, part) = call;
        return part;
    });
}

Result<PlanEdit> replaceSense(std::string_view text, const PlanPart& part, const SenseTest& test) {
    return changePlan(text, [&](Plan& plan) -> Result<PlanPart> {
        if (!senseOf(plan, part))
            return noSuchPart();
        senseIn(plan, part) = test;
        return part;
    });
}

Result<PlanEdit> setSenses(std::string_view text, const PlanPart& owner, const Senses& senses) {
    return changePlan(text, [&](Plan& plan) -> Result<PlanPart> {
        Senses* const old = sensesIn(plan, owner);
        if (!old)
            return noSuchPart();
        *old = senses;
        return owner;
    });
}

Result<PlanEdit> setLimit(std::string_view text, const PlanPart& owner, std::string_view words) {
    return changePlan(text, [&](Plan& plan) -> Result<PlanPart> {
        if (!nameOf(plan, owner))
            return noSuchPart();
        const auto timeLimit = [](auto& any) -> decltype(&any.time_limit) { return &any.time_limit; };
        Form& form = plan.forms[owner.form];
        const bool is_member = owner.kind == PartKind::Member;
        if (is_member && std::holds_alternative<Competence>(form)) {
            auto retries = readRetriesPhrase(words);
            if (!retries)
                return tl::unexpected(retries.error());
            memberIn(plan, owner).retries = *std::move(retries);
            return owner;
        }
        auto interval = readIntervalPhrase(words, is_member);
        if (!interval)
            return tl::unexpected(interval.error());
        if (is_member)
            memberIn(plan, owner).frequency = *std::move(interval);
        else if (auto* const time_limit = fieldOf<std::optional<Interval>>(form, timeLimit))
            *time_limit = *std::move(interval);
        else
            return failure("it cannot have a limit", describe(plan, owner));
        return owner;
    });
}

Result<PlanEdit> setComment(std::string_view text, const PlanPart& owner, std::string_view words) {
    return changePlan(text, [&](Plan& plan) -> Result<PlanPart> {
        auto* const comment =
            fieldIn(plan, owner, &Member::comment, [](auto& form) -> decltype(&form.comment) { return &form.comment; });
        if (!comment)
            return failure("it cannot have a comment", describe(plan, owner), "write ; and the comment in the text");
        *comment = words.empty() ? std::nullopt : std::optional(Literal{std::string(words), quoted(words), {}});
        return owner;
    });
}

Result<PlanEdit> wrapCall(std::string_view text, const PlanPart& part, FormKind kind, std::string name) {
    return changePlan(text, [&](Plan& plan) -> Result<PlanPart> {
        const bool is_member = part.kind == PartKind::Member;
        const PlanPart place = is_member ? actionPart(part.form, part.level, part.member) : part;
        if (place.kind != PartKind::Action || !callOf(plan, place) || kind == FormKind::Dc)
            return noSuchPart();
        Call& call = callIn(plan, place);
        constexpr const char* beginnings[] = {"choose-", "do-", "keep-"};
        auto reference = referenceTo(plan, name, beginnings[static_cast<int>(kind)] + withoutModule(call.name.text));
        if (!reference)
            return tl::unexpected(reference.error());
        std::vector<Formal> formals;
        handOn(call, plan.forms[part.form], *reference, formals);
        Form made = madeForm(kind, name, std::move(formals), call);
        call = *std::move(reference);
        return insertForm(plan, part.form, std::move(made));
    });
}

Result<PlanEdit> inlineCall(std::string_view text, const PlanPart& part) {
    return changePlan(text, [&](Plan& plan) -> Result<PlanPart> {
        const Call* const call = part.kind == PartKind::Action ? callOf(plan, part) : nullptr;
        const auto target = call ? FormIndex(plan).find(call->name.text) : std::nullopt;
        if (!target || *target == part.form)
            return noSuchPart();
        const auto content = contentOf(plan.forms[*target]);
        const bool is_step = isStep(plan, part);
        const bool fits =
            content && (is_step || (content->size() == 1 && std::holds_alternative<Call>(content->front())));
        if (!fits)
            return failure(
                "it does more than fits here", describe(plan, formPart(*target)),
                "only a pattern in a pattern, or a form that does one thing, can be put in place of its call");
        const bool is_last_call = usagesOf(plan, part).size() == 2;
        PlanPart result = part;
        if (is_step) {
            auto& steps = std::get<Pattern>(plan.forms[part.form]).steps;
            eraseAt(steps, part.index);
            steps.insert(steps.begin() + static_cast<std::ptrdiff_t>(part.index), content->begin(), content->end());
            if (std::holds_alternative<SenseTest>(content->front()))
                result.kind = PartKind::Sense;
        } else {
            callIn(plan, part) = std::get<Call>(content->front());
        }
        if (!is_last_call || hasRemarks(plan.forms[*target]))
            return result;
        eraseAt(plan.forms, *target);
        result.form -= *target < part.form ? 1 : 0;
        return result;
    });
}

} // namespace usar::posh
