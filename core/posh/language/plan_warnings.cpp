#include "core/posh/language/plan_warnings.h"

#include <string>

#include "core/posh/model/name_set.h"

namespace usar::posh {

namespace {

void add(Findings& findings, Code code, const Spot& at, std::string message) {
    findings.push_back({code, at, std::move(message), std::nullopt});
}

template <class Levels>
void warnOfDuplicates(const Levels& levels, Code code, Findings& findings) {
    NameSet seen;
    for (const auto& level : levels)
        for (const auto& member : level)
            if (!seen.insert(member.name.text))
                add(findings, code, member.name.at,
                    "the name " + inQuotes(member.name.text) + " is used twice here; give one of the two another name");
}

bool isAlwaysTaken(const Element& element) {
    return element.trigger.empty() && !retryLimit(element);
}

bool isAlwaysTaken(const Drive& drive) {
    const bool has_limit = drive.frequency && numberOf(drive.frequency->amount.value) != 0.0;
    return drive.trigger.empty() && !has_limit;
}

void warnOfNeverReached(const Name& name, const Name& always, Findings& findings) {
    add(findings, Code::NeverReached, name.at,
        inQuotes(name.text) + " is never reached: " + inQuotes(always.text) +
            " before it is always ready; give that a trigger, or move it to the end");
}

/// Warns of elements after one that is always ready. Elements are tried in their order, even within a level.
void warnOfNeverReached(const std::vector<ElementLevel>& levels, Findings& findings) {
    const Name* always = nullptr;
    for (const ElementLevel& level : levels)
        for (const Element& element : level) {
            if (always)
                warnOfNeverReached(element.name, *always, findings);
            else if (isAlwaysTaken(element))
                always = &element.name;
        }
}

/// Warns of drives below a level with one that is always ready. Drives in one level take turns, so only a drive in a
/// higher level can keep another from ever running.
void warnOfNeverReached(const std::vector<DriveLevel>& levels, Findings& findings) {
    const Name* always = nullptr;
    for (const DriveLevel& level : levels) {
        const Name* here = nullptr;
        for (const Drive& drive : level) {
            if (always)
                warnOfNeverReached(drive.name, *always, findings);
            else if (isAlwaysTaken(drive))
                here = &drive.name;
        }
        always = always ? always : here;
    }
}

/// Warns of a competence that may find no ready element and then fails. A goal, or a last element without a trigger,
/// prevents that.
void warnOfFindingNothing(const Competence& competence, Findings& findings) {
    if (competence.levels.empty() || competence.levels.back().empty() || !competence.goal.empty())
        return;
    const Element& last = competence.levels.back().back();
    if (!last.trigger.empty())
        add(findings, Code::MayFindNothing, competence.name.at,
            "no element of " + inQuotes(competence.name.text) +
                " may be ready; add a last one without a trigger, or a goal");
}

void warnOfForm(const Form& form, Findings& findings) {
    if (const auto* const collection = std::get_if<Collection>(&form)) {
        warnOfDuplicates(collection->levels, Code::DuplicateDrive, findings);
        warnOfNeverReached(collection->levels, findings);
    } else if (const auto* const competence = std::get_if<Competence>(&form)) {
        warnOfDuplicates(competence->levels, Code::DuplicateElement, findings);
        warnOfNeverReached(competence->levels, findings);
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
            add(findings, Code::NeverUsed, name.at, inQuotes(name.text) + " is never used; call it, or take it away");
    }
}

} // namespace usar::posh
