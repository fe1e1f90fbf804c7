// Edits that move parts of a plan, and those that add a member or a step at a given place.
#include <algorithm>
#include <variant>

#include "core/posh/edit/plan_change.h"

namespace usar::posh {

namespace {

using Member = std::variant<Drive, Element>;

Result<Drive> asDrive(Member member) {
    if (auto* const drive = std::get_if<Drive>(&member))
        return std::move(*drive);
    Element& element = std::get<Element>(member);
    if (element.retries)
        return failure("it has a number of retries, which drives have not", inQuotes(element.name.text),
                       "take that away first");
    return Drive{std::move(element.name),
                 std::move(element.trigger),
                 std::move(element.action),
                 std::nullopt,
                 std::move(element.comment),
                 std::move(element.remarks),
                 {}};
}

Result<Element> asElement(Member member) {
    if (auto* const element = std::get_if<Element>(&member))
        return std::move(*element);
    Drive& drive = std::get<Drive>(member);
    if (drive.frequency)
        return failure("it has a frequency, which elements have not", inQuotes(drive.name.text),
                       "take that away first");
    return Element{std::move(drive.name),
                   std::move(drive.trigger),
                   std::move(drive.action),
                   std::nullopt,
                   std::move(drive.comment),
                   std::move(drive.remarks),
                   {}};
}

template <class Kind>
Result<PlanPart> putIn(std::vector<std::vector<Kind>>& levels, const MemberPlace& to, Result<Kind> member) {
    if (!member)
        return tl::unexpected(member.error());
    const std::size_t level = std::min(to.level, levels.size());
    if (!to.beside || level == levels.size()) {
        levels.insert(levels.begin() + static_cast<std::ptrdiff_t>(level), {*std::move(member)});
        return memberPart(to.form, level, 0);
    }
    auto& equals = levels[level];
    const std::size_t place = std::min(*to.beside, equals.size());
    equals.insert(equals.begin() + static_cast<std::ptrdiff_t>(place), *std::move(member));
    return memberPart(to.form, level, place);
}

Result<PlanPart> put(Plan& plan, const MemberPlace& to, Member member) {
    if (to.form >= plan.forms.size())
        return noSuchPart();
    Form& form = plan.forms[to.form];
    if (auto* const collection = std::get_if<Collection>(&form))
        return putIn(collection->levels, to, asDrive(std::move(member)));
    if (auto* const competence = std::get_if<Competence>(&form))
        return putIn(competence->levels, to, asElement(std::move(member)));
    return failure("only a collection and a competence have such parts", nameOf(form).text, "choose another place");
}

/// Removes a member from its levels and corrects the indices of the place where it will be inserted.
template <class Levels>
Member takeFrom(Levels& levels, const PlanPart& part, MemberPlace& to) {
    auto& level = levels[part.level];
    Member taken = std::move(level[part.member]);
    level.erase(level.begin() + static_cast<std::ptrdiff_t>(part.member));
    const bool same_form = to.form == part.form;
    if (same_form && to.beside && to.level == part.level && *to.beside > part.member)
        --*to.beside;
    if (level.empty()) {
        levels.erase(levels.begin() + static_cast<std::ptrdiff_t>(part.level));
        if (same_form && to.level > part.level)
            --to.level;
    }
    return taken;
}

template <class Levels>
std::size_t memberCount(const Levels& levels) {
    std::size_t count = 0;
    for (const auto& level : levels)
        count += level.size();
    return count;
}

Result<Member> take(Plan& plan, const PlanPart& part, MemberPlace& to) {
    Form& form = plan.forms[part.form];
    if (auto* const competence = std::get_if<Competence>(&form))
        return takeFrom(competence->levels, part, to);
    auto& levels = std::get<Collection>(form).levels;
    if (memberCount(levels) == 1 && to.form != part.form)
        return failure("it is the last drive of the plan", nameOf(plan, part)->text, "add another one first");
    return takeFrom(levels, part, to);
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
    LevelSizes sizes;
    std::visit(
        [&](const auto& form) {
            if constexpr (requires { form.levels; })
                sizes = {form.levels.size(), form.levels[part.level].size(),
                         part.level > 0 ? form.levels[part.level - 1].size() : 0};
        },
        plan.forms[part.form]);
    return sizes;
}

tl::unexpected<Error> atTheEnd(const Plan& plan, const PlanPart& part, int by) {
    return failure(by < 0 ? "it is the first already" : "it is the last already", describe(plan, part));
}

/// Swaps a sense with its neighbor in the goal or trigger; fails at the first or last one.
Result<PlanPart> shiftSense(Plan& plan, const PlanPart& part, int by) {
    PlanPart other = part;
    if (by < 0 && part.index == 0)
        return atTheEnd(plan, part, by);
    other.index = by < 0 ? part.index - 1 : part.index + 1;
    if (!senseOf(plan, other))
        return atTheEnd(plan, part, by);
    std::swap(const_cast<SenseTest&>(*senseOf(plan, part)), const_cast<SenseTest&>(*senseOf(plan, other)));
    return other;
}

Result<PlanPart> shiftForm(Plan& plan, const PlanPart& part, int by) {
    const bool at_end = by < 0 ? part.form == 0 : part.form + 1 == plan.forms.size();
    if (at_end)
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
        auto taken = take(plan, part, place);
        if (!taken)
            return tl::unexpected(taken.error());
        return put(plan, place, *std::move(taken));
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
        steps.erase(steps.begin() + static_cast<std::ptrdiff_t>(part.index));
        std::size_t place = form == part.form && index > part.index ? index - 1 : index;
        place = std::min(place, to->steps.size());
        to->steps.insert(to->steps.begin() + static_cast<std::ptrdiff_t>(place), std::move(step));
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
        const std::string own = action.name.text.substr(action.name.text.rfind('.') + 1);
        name = freeMemberName(plan.forms[to.form], name.empty() ? own : name);
        return put(plan, to,
                   Element{{std::move(name), {}}, trigger, action, std::nullopt, std::nullopt, Remarks(), {}});
    });
}

Result<PlanEdit> addStep(std::string_view text, std::size_t form, std::size_t index, const Step& step) {
    return changePlan(text, [&](Plan& plan) -> Result<PlanPart> {
        auto* const pattern = form < plan.forms.size() ? std::get_if<Pattern>(&plan.forms[form]) : nullptr;
        if (!pattern)
            return noSuchPart();
        const std::size_t place = std::min(index, pattern->steps.size());
        pattern->steps.insert(pattern->steps.begin() + static_cast<std::ptrdiff_t>(place), step);
        const bool is_sense = std::holds_alternative<SenseTest>(step);
        return PlanPart{is_sense ? PartKind::Sense : PartKind::Action, form, 0, 0, place};
    });
}

} // namespace usar::posh
