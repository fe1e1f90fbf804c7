#include "core/posh/language/plan_reader.h"

#include <algorithm>
#include <string>

#include "core/base/spelling.h"
#include "core/posh/language/form_index.h"
#include "core/posh/model/name_set.h"

namespace usar::posh {

namespace {

void checkNames(const Plan& plan, const FormIndex& index, Findings& findings) {
    for (std::size_t i = 0; i < plan.forms.size(); ++i) {
        const Name& name = nameOf(plan.forms[i]);
        const auto first = index.find(name.text);
        if (std::holds_alternative<Collection>(plan.forms[i]) || first == i)
            continue;
        const Spot& at = nameOf(plan.forms[*first]).at;
        findings.push_back({Code::DuplicateName, name.at,
                            "the name " + inQuotes(name.text) + " is already used at " + std::to_string(at.line) + ':' +
                                std::to_string(at.column) + "; give this one another name"});
    }
}

/// Limits for the search of a similar name: comparing two names costs the product of their lengths.
constexpr std::size_t longest_compared = 40;
constexpr std::size_t most_compared = 50;

std::string nearestFormal(const std::string& name, const std::unordered_set<std::string_view>& known) {
    if (known.size() > most_compared || name.size() > longest_compared)
        return {};
    std::vector<std::string> names;
    for (const std::string_view formal : known)
        if (formal.size() <= longest_compared)
            names.emplace_back(formal);
    return nearestWord(name, names);
}

std::string freeVariableMessage(const std::string& name, const std::string& nearest, bool in_collection) {
    const std::string what = inQuotes("$" + name);
    if (in_collection)
        return what + " has no value here: a collection has no parameters; write a value";
    return what + " is not a parameter of this form; " + (nearest.empty() ? "" : "write $" + nearest + " or ") +
           "declare it with vars($name=value)";
}

void checkVariables(const Plan& plan, const FormIndex& index, Findings& findings) {
    std::size_t compared = 0;
    for (const auto& [variable, form] : index.variables()) {
        if (index.declares(form, variable->name))
            continue;
        const bool in_collection = std::holds_alternative<Collection>(plan.forms[form]);
        const bool compares = compared++ < most_compared;
        const std::string nearest = compares ? nearestFormal(variable->name, index.formals(form)) : "";
        findings.push_back(
            {Code::FreeVariable, variable->at, freeVariableMessage(variable->name, nearest, in_collection)});
    }
}

/// Appends an error E302 for each reference that closes a cycle, even if the collection never reaches it. A
/// depth-first search with an explicit stack, because a plan can be nested too deeply for recursion.
class CycleSearch {
public:
    CycleSearch(const Plan& plan, const FormIndex& index)
        : plan_(&plan)
        , references_(index.references())
        , first_(plan.forms.size() + 1)
        , states_(plan.forms.size()) {
        for (const Reference& reference : references_)
            ++first_[reference.form + 1];
        for (std::size_t form = 0; form < plan.forms.size(); ++form)
            first_[form + 1] += first_[form];
    }

    void run(Findings& findings) {
        for (std::size_t form = 0; form < states_.size(); ++form) {
            const bool is_root = std::holds_alternative<Collection>(plan_->forms[form]); // Nothing can refer to it
            if (states_[form] == State::New && !is_root)
                enter(form);
            while (!path_.empty())
                step(findings);
        }
    }

private:
    enum class State { New, OnPath, Done };
    struct Visit {
        std::size_t form = 0;
        std::size_t next = 0; ///< index of the next reference to follow
    };

    void enter(std::size_t form) {
        states_[form] = State::OnPath;
        path_.push_back({form, first_[form]});
    }
    void step(Findings& findings) {
        Visit& top = path_.back();
        if (top.next == first_[top.form + 1]) {
            states_[top.form] = State::Done;
            path_.pop_back();
            return;
        }
        const Reference& reference = references_[top.next++];
        if (states_[reference.target] == State::New)
            enter(reference.target);
        else if (states_[reference.target] == State::OnPath)
            findings.push_back({Code::ReferenceCycle, reference.call->name.at, message(reference)});
    }
    std::string message(const Reference& closing) const {
        constexpr std::ptrdiff_t most_named = 6;
        auto at =
            std::find_if(path_.begin(), path_.end(), [&](const Visit& visit) { return visit.form == closing.target; });
        std::string way = inQuotes(nameOf(plan_->forms[closing.target]).text);
        const bool is_long = path_.end() - at > most_named;
        if (++at == path_.end())
            return way + " contains itself; call something else here";
        way += " contains itself through ";
        for (const auto last = is_long ? at + most_named : path_.end(); at != last; ++at)
            way += (way.ends_with(' ') ? "" : ", ") + inQuotes(nameOf(plan_->forms[at->form]).text);
        return way + (is_long ? ", …" : "") + "; call something else here";
    }

    const Plan* plan_;
    const std::vector<Reference>& references_;
    std::vector<std::size_t> first_; ///< index of each form's first reference, and the number of references at the end
    std::vector<State> states_;
    std::vector<Visit> path_;
};

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

/// Appends the warnings W401 to W404 and W410 to W412; without W401 and W404 if `is_whole` is false.
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

} // namespace

Findings checkPlan(const Plan& plan, bool is_whole) {
    Findings findings;
    const FormIndex index(plan);
    checkNames(plan, index, findings);
    checkVariables(plan, index, findings);
    CycleSearch(plan, index).run(findings);
    warnOfPlan(plan, index, is_whole, findings);
    return findings;
}

} // namespace usar::posh
