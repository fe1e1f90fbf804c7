#include "core/posh/language/plan_check.h"

#include <string>

#include "core/base/spelling.h"

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

} // namespace

Findings checkPlan(const Plan& plan, bool is_whole) {
    Findings findings;
    const FormIndex index(plan);
    checkNames(plan, index, findings);
    checkVariables(plan, index, findings);
    checkReferenceCycles(plan, index, findings);
    warnOfPlan(plan, index, is_whole, findings);
    return findings;
}

} // namespace usar::posh
