// Edits that move parts of a plan, and those that add a member or a step at a given place.
#include <algorithm>

#include "core/posh/edit/plan_change.h"

namespace usar::posh {

namespace {

/// Puts a member into a form. A drive becomes an element of a competence, an element a drive of a collection.
Result<PlanPart> put(Plan& plan, const MemberPlace& to, Member member) {
    if (to.form >= plan.forms.size())
        return noSuchPart();
    Form& form = plan.forms[to.form];
    Levels* const levels = levelsIn(form);
    if (!levels)
        return failure("only a collection and a competence have such parts", nameOf(form).text, "choose another place");
    const bool is_drive = std::holds_alternative<Collection>(form);
    if (is_drive && member.retries)
        return failure("it has a number of retries, which a drive cannot have", inQuotes(member.name.text),
                       "remove that first");
    if (!is_drive && member.frequency)
        return failure("it has a frequency, which an element cannot have", inQuotes(member.name.text),
                       "remove that first");
    const std::size_t level = std::min(to.level, levels->size());
    if (!to.beside || level == levels->size()) {
        insertAt(*levels, level, Level{std::move(member)});
        return memberPart(to.form, level, 0);
    }
    Level& equals = (*levels)[level];
    const std::size_t place = std::min(*to.beside, equals.size());
    insertAt(equals, place, std::move(member));
    return memberPart(to.form, level, place);
}

/// Removes a member from its form and corrects the indices of the place where it will be inserted.
Result<Member> take(Plan& plan, const PlanPart& part, MemberPlace& to) {
    Form& form = plan.forms[part.form];
    Levels& levels = *levelsIn(form);
    Level& level = levels[part.level];
    const bool same_form = to.form == part.form;
    const bool is_last = levels.size() == 1 && level.size() == 1;
    if (is_last && !same_form && std::holds_alternative<Collection>(form))
        return failure("it is the last drive of the plan", level[part.member].name.text, "add another one first");
    Member taken = std::move(level[part.member]);
    eraseAt(level, part.member);
    if (same_form && to.beside && to.level == part.level && *to.beside > part.member)
        --*to.beside;
    if (level.empty()) {
        eraseAt(levels, part.level);
        if (same_form && to.level > part.level)
            --to.level;
    }
    return taken;
}

/// Returns whether moving the member to this place would change nothing.
bool staysWhereItIs(std::size_t members_of_level, const PlanPart& part, const MemberPlace& to) {
    if (to.form != part.form)
        return false;
    if (to.beside)
        return to.level == part.level && (*to.beside == part.member || *to.beside == part.member + 1);
    return members_of_level == 1 && (to.level == part.level || to.level == part.level + 1);
}

struct LevelSizes {
    std::size_t levels = 0; ///< number of levels
    std::size_t own = 0;    ///< members in the level itself
    std::size_t before = 0; ///< members in the level before it; 0 if there is none
};

/// Returns the sizes of a member's level and of the one before it.
LevelSizes sizesAround(const Plan& plan, const PlanPart& part) {
    const Levels& levels = *levelsIn(plan.forms[part.form]);
    return {levels.size(), levels[part.level].size(), part.level > 0 ? levels[part.level - 1].size() : 0};
}

tl::unexpected<Error> atTheEnd(const Plan& plan, const PlanPart& part, int by) {
    return failure(by < 0 ? "it is already the first" : "it is already the last", describe(plan, part));
}

/// Swaps a sense with its neighbor in the goal or trigger; fails at the first or last one.
Result<PlanPart> shiftSense(Plan& plan, const PlanPart& part, int by) {
    PlanPart other = part;
    other.index = by < 0 ? part.index - 1 : part.index + 1; // Wraps around before the first, where there is no sense
    if (!senseOf(plan, other))
        return atTheEnd(plan, part, by);
    std::swap(senseIn(plan, part), senseIn(plan, other));
    return other;
}

Result<PlanPart> shiftForm(Plan& plan, const PlanPart& part, int by) {
    if (by < 0 ? part.form == 0 : part.form + 1 == plan.forms.size())
        return atTheEnd(plan, part, by);
    const std::size_t other = by < 0 ? part.form - 1 : part.form + 1;
    std::swap(plan.forms[part.form], plan.forms[other]);
    return formPart(other);
}

} // namespace

Result<PlanEdit> moveMember(std::string_view text, const PlanPart& part, const MemberPlace& to) {
    return changePlan(text, [&](Plan& plan) -> Result<PlanPart> {
        if (part.kind != PartKind::Member || !nameOf(plan, part))
            return noSuchPart();
        if (staysWhereItIs(sizesAround(plan, part).own, part, to))
            return part;
        MemberPlace place = to;
        return take(plan, part, place).and_then([&](Member taken) { return put(plan, place, std::move(taken)); });
    });
}

Result<PlanEdit> moveStep(std::string_view text, const PlanPart& part, std::size_t form, std::size_t index) {
    return changePlan(text, [&](Plan& plan) -> Result<PlanPart> {
        auto* const to = form < plan.forms.size() ? std::get_if<Pattern>(&plan.forms[form]) : nullptr;
        if (!isStep(plan, part) || !to)
            return noSuchPart();
        auto& steps = std::get<Pattern>(plan.forms[part.form]).steps;
        if (steps.size() == 1 && form != part.form)
            return failure("it is the last step of its pattern", describe(plan, part), "add another one first");
        Step step = std::move(steps[part.index]);
        eraseAt(steps, part.index);
        std::size_t place = form == part.form && index > part.index ? index - 1 : index;
        place = std::min(place, to->steps.size());
        insertAt(to->steps, place, std::move(step));
        return PlanPart{part.kind, form, 0, 0, place};
    });
}

Result<PlanEdit> shiftPart(std::string_view text, const PlanPart& part, int by) {
    const auto before = readForEdit(text);
    if (!before)
        return tl::unexpected(before.error());
    const Plan& plan = before->plan;
    if (!nameOf(plan, part))
        return noSuchPart();
    if (isStep(plan, part)) {
        const auto steps = std::get<Pattern>(plan.forms[part.form]).steps.size();
        if (by < 0 ? part.index == 0 : part.index + 1 == steps)
            return atTheEnd(plan, part, by);
        return moveStep(text, part, part.form, by < 0 ? part.index - 1 : part.index + 2);
    }
    if (part.kind == PartKind::Sense)
        return changePlan(text, [&](Plan& changed) { return shiftSense(changed, part, by); });
    if (part.kind == PartKind::Whole || !(part.in_member || part.kind == PartKind::Member))
        return changePlan(text, [&](Plan& changed) { return shiftForm(changed, formPart(part.form), by); });
    const PlanPart member = memberPart(part.form, part.level, part.member);
    const LevelSizes sizes = sizesAround(plan, part);
    if (sizes.own > 1)
        return moveMember(text, member, {part.form, by < 0 ? part.level : part.level + 1});
    if (by < 0 ? part.level == 0 : part.level + 1 == sizes.levels)
        return atTheEnd(plan, member, by);
    return moveMember(text, member, {part.form, by < 0 ? part.level - 1 : part.level + 2});
}

Result<PlanEdit> joinLevel(std::string_view text, const PlanPart& part, int by) {
    const auto before = readForEdit(text);
    if (!before)
        return tl::unexpected(before.error());
    if (part.kind != PartKind::Member || !nameOf(before->plan, part))
        return noSuchPart();
    const LevelSizes sizes = sizesAround(before->plan, part);
    if (by < 0 ? part.level == 0 : part.level + 1 == sizes.levels)
        return atTheEnd(before->plan, part, by);
    if (by < 0)
        return moveMember(text, part, {part.form, part.level - 1, sizes.before});
    return moveMember(text, part, {part.form, part.level + 1, std::size_t{0}});
}

Result<PlanEdit> addMember(std::string_view text, const MemberPlace& to, const Call& action, const Senses& trigger,
                           std::string name) {
    return changePlan(text, [&](Plan& plan) -> Result<PlanPart> {
        if (to.form >= plan.forms.size())
            return noSuchPart();
        name = freeMemberName(plan.forms[to.form], name.empty() ? withoutModule(action.name.text) : name);
        return put(plan, to, Member{.name = {std::move(name)}, .trigger = trigger, .action = action});
    });
}

Result<PlanEdit> addStep(std::string_view text, std::size_t form, std::size_t index, const Step& step) {
    return changePlan(text, [&](Plan& plan) -> Result<PlanPart> {
        auto* const pattern = form < plan.forms.size() ? std::get_if<Pattern>(&plan.forms[form]) : nullptr;
        if (!pattern)
            return noSuchPart();
        const std::size_t place = std::min(index, pattern->steps.size());
        insertAt(pattern->steps, place, step);
        const bool is_sense = std::holds_alternative<SenseTest>(step);
        return PlanPart{is_sense ? PartKind::Sense : PartKind::Action, form, 0, 0, place};
    });
}

} // namespace usar::posh
