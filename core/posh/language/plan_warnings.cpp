#include "core/posh/language/plan_check.h"

#include <string>

#include "core/posh/model/name_set.h"

namespace usar::posh {

namespace {

void add(Findings& findings, Code code, const Spot& at, std::string message) {
    findings.push_back({code, at, std::move(message)});
}

void warnOfDuplicates(const Levels& levels, Code code, Findings& findings) {
    NameSet seen;
    for (const Level& level : levels)
        for (const Member& member : level)
            if (!seen.insert(member.name.text))
                add(findings, code, member.name.at,
                    "the name " + inQuotes(member.name.text) + " is used twice here; give one of the two another name");
}

bool isAlwaysTaken(const Member& member) {
    const bool waits = member.frequency && numberOf(member.frequency->amount.value) != 0.0;
    return member.trigger.empty() && !waits && !retryLimit(member);
}

/// Warns of members that one before them keeps from ever running. Elements are tried in their order, even within a
/// level; drives in one level take turns, so only a drive in a higher level (`equals_take_turns`) counts.
void warnOfNeverReached(const Levels& levels, bool equals_take_turns, Findings& findings) {
    const Name* always = nullptr;
    for (const Level& level : levels) {
        const Name* here = always;
        for (const Member& member : level) {
            if (const Name* const before = equals_take_turns ? always : here)
                add(findings, Code::NeverReached, member.name.at,
                    inQuotes(member.name.text) + " is never reached: " + inQuotes(before->text) +
                        " before it is always ready; give that a trigger, or move it to the end");
            else if (isAlwaysTaken(member))
                here = &member.name;
        }
        always = here;
    }
}

/// Warns of a competence that may find no ready element and then fails. A goal, or a last element without a trigger,
/// prevents that.
void warnOfFindingNothing(const Competence& competence, Findings& findings) {
    if (competence.levels.empty() || competence.levels.back().empty() || !competence.goal.empty())
        return;
    const Member& last = competence.levels.back().back();
    if (!last.trigger.empty())
        add(findings, Code::MayFindNothing, competence.name.at,
            "no element of " + inQuotes(competence.name.text) +
                " may be ready; add a last one without a trigger, or a goal");
}

void warnOfForm(const Form& form, Findings& findings) {
    if (const auto* const collection = std::get_if<Collection>(&form)) {
        warnOfDuplicates(collection->levels, Code::DuplicateDrive, findings);
        warnOfNeverReached(collection->levels, true, findings);
    } else if (const auto* const competence = std::get_if<Competence>(&form)) {
        warnOfDuplicates(competence->levels, Code::DuplicateElement, findings);
        warnOfNeverReached(competence->levels, false, findings);
        warnOfFindingNothing(*competence, findings);
    }
}

void warnOfArguments(const Call& call, const Plan& plan, const FormIndex& index, std::size_t target,
                     Findings& findings) {
    const std::size_t formals = formalsOf(plan.forms[target]).size();
    for (std::size_t i = 0; i < call.arguments.size(); ++i) {
        const Argument& argument = call.arguments[i];
        const std::string whom = inQuotes(call.name.text);
        if (argument.name.empty() && i >= formals)
            add(findings, Code::UndeclaredArgument, argument.at,
                whom + " has fewer parameters, so this argument is ignored; leave it out, or declare it");
        else if (!argument.name.empty() && !index.declares(target, argument.name))
            add(findings, Code::UndeclaredArgument, argument.at,
                whom + " declares no " + inQuotes("$" + argument.name) +
                    ", which is passed down; declare it, or correct the name");
    }
}

} // namespace

void warnOfPlan(const Plan& plan, const FormIndex& index, bool is_whole, Findings& findings) {
    for (const Form& form : plan.forms)
        warnOfForm(form, findings);
    std::vector<bool> used(plan.forms.size(), false);
    for (const Reference& reference : index.references()) {
        used[reference.target] = true;
        warnOfArguments(*reference.call, plan, index, reference.target, findings);
    }
    if (!is_whole)
        return;
    if (!collectionOf(plan)) {
        const Spot at = plan.forms.empty() ? Spot{1, 1, 0, 0} : nameOf(plan.forms.front()).at;
        add(findings, Code::Fragment, at,
            "the plan has no drive collection and cannot run; add (DC name (drives ((name action))))");
        return; // The forms of a fragment are used elsewhere
    }
    for (std::size_t i = 0; i < used.size(); ++i) {
        const Name& name = nameOf(plan.forms[i]);
        if (!used[i] && !std::holds_alternative<Collection>(plan.forms[i]) && index.find(name.text) == i)
            add(findings, Code::NeverUsed, name.at, inQuotes(name.text) + " is never used; call it, or remove it");
    }
}

} // namespace usar::posh
