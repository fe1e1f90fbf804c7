#include "core/posh/edit/plan_edits.h"

#include <algorithm>
#include <map>

#include "core/posh/edit/plan_change.h"
#include "core/posh/edit/plan_phrase.h"
#include "core/posh/language/form_index.h"
#include "core/posh/language/token_splice.h"

namespace usar::posh {

namespace {

std::map<Code, int> errorsByCode(const Findings& findings) {
    std::map<Code, int> count;
    for (const Finding& finding : findings)
        if (severityOf(finding.code) == Severity::Error)
            ++count[finding.code];
    return count;
}

/// Fails if a form or an act of the plan has this name. Calls would change their meaning if a form got the name of an
/// act that is in use, or an act the name of a form.
Result<void> checkMeaning(const Plan& plan, std::string_view name) {
    for (const NamedPart& other : partsOf(plan)) {
        if (other.name->text != name)
            continue;
        const bool is_form =
            other.part.kind == PartKind::Whole && !std::holds_alternative<Collection>(plan.forms[other.part.form]);
        if (is_form || other.part.kind == PartKind::Action)
            return failure("this name is taken by " + describe(plan, other.part), inQuotes(name),
                           "choose another name");
    }
    return {};
}

Result<void> checkRename(const Plan& plan, const PlanPart& part, std::string_view name) {
    const bool is_sense = part.kind == PartKind::Sense;
    const bool is_primitive =
        is_sense || (part.kind == PartKind::Action && !FormIndex(plan).find(nameOf(plan, part)->text));
    if (const auto good = checkName(name, is_primitive); !good)
        return good;
    if (part.kind == PartKind::Member)
        return freeMemberName(plan.forms[part.form], std::string(name)) == name
                   ? Result<void>()
                   : failure("another one next to it has this name", inQuotes(name), "choose another name");
    const bool is_collection =
        part.kind == PartKind::Whole && std::holds_alternative<Collection>(plan.forms[part.form]);
    if (is_collection || is_sense)
        return {};
    if (is_primitive) // An act may get the name of another act
        return FormIndex(plan).find(name)
                   ? failure("a form of the plan has this name", inQuotes(name), "choose another name")
                   : Result<void>();
    return checkMeaning(plan, name);
}

/// Swaps two parts of the same kind and returns the new place of the first.
Result<PlanPart> swapIn(Plan& plan, const PlanPart& a, const PlanPart& b) {
    if (isStep(plan, a) && isStep(plan, b)) {
        auto& from = std::get<Pattern>(plan.forms[a.form]).steps;
        auto& to = std::get<Pattern>(plan.forms[b.form]).steps;
        std::swap(from[a.index], to[b.index]);
        PlanPart there = b;
        there.kind = a.kind;
        return there;
    }
    if (a.kind != b.kind)
        return failure("these two are of different kinds", describe(plan, a) + " and " + describe(plan, b),
                       "choose two acts, two senses, two elements or two drives");
    if (a.kind == PartKind::Whole)
        std::swap(plan.forms[a.form], plan.forms[b.form]);
    else if (a.kind == PartKind::Action)
        std::swap(callIn(plan, a), callIn(plan, b));
    else if (a.kind == PartKind::Sense)
        std::swap(senseIn(plan, a), senseIn(plan, b));
    else if (plan.forms[a.form].index() == plan.forms[b.form].index())
        std::swap(memberIn(plan, a), memberIn(plan, b));
    else
        return failure("a drive and an element cannot be swapped", describe(plan, a), "move one of them");
    return b;
}

} // namespace

Result<PlanReading> readForEdit(std::string_view text) {
    PlanReading reading = readPlan(text);
    for (const Finding& finding : reading.findings)
        if (isUnreadable(finding.code))
            return failure("the text cannot be read here", "line " + std::to_string(finding.at.line),
                           "fix it first: " + finding.message);
    return reading;
}

Result<PlanEdit> checkedEdit(const PlanReading& before, std::string text, const PlanPart& part) {
    const Findings after = readPlan(text).findings;
    const std::map<Code, int> old = errorsByCode(before.findings);
    for (const auto& [code, count] : errorsByCode(after)) {
        const auto known = old.find(code);
        if (count <= (known == old.end() ? 0 : known->second))
            continue;
        const auto bad = std::ranges::find(after, code, &Finding::code);
        return failure("this would cause an error (" + toText(code) + ")", "", bad->message);
    }
    return PlanEdit{std::move(text), part};
}

Result<PlanEdit> renamePart(std::string_view text, const PlanPart& part, std::string_view name) {
    const auto before = readForEdit(text);
    if (!before)
        return tl::unexpected(before.error());
    const Name* const old = nameOf(before->plan, part);
    if (!old)
        return noSuchPart();
    if (old->text == name)
        return PlanEdit{std::string(text), part};
    if (const auto good = checkRename(before->plan, part, name); !good)
        return tl::unexpected(good.error());
    std::vector<Splice> splices;
    for (const PlanPart& usage : usagesOf(before->plan, part)) {
        const Spot& at = nameOf(before->plan, usage)->at;
        splices.push_back({at.offset, at.end(), std::string(name)});
    }
    return checkedEdit(*before, spliced(text, 0, text.size(), splices), part);
}

Result<PlanEdit> swapParts(std::string_view text, const PlanPart& a, const PlanPart& b) {
    return changePlan(text, [&](Plan& plan) -> Result<PlanPart> {
        if (!nameOf(plan, a) || !nameOf(plan, b))
            return noSuchPart();
        return swapIn(plan, a, b);
    });
}

} // namespace usar::posh
