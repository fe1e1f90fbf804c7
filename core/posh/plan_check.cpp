#include "core/posh/plan_check.h"

#include <string>

#include "core/base/spelling.h"
#include "core/posh/form_index.h"
#include "core/posh/plan_walk.h"
#include "core/posh/plan_warnings.h"
#include "core/posh/reference_cycles.h"

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
                            "the name \"" + name.text + "\" stands at " + std::to_string(at.line) + ':' +
                                std::to_string(at.column) + " already; give this one another name",
                            std::nullopt});
    }
}

std::string freeVariableMessage(const Variable& variable, bool in_collection,
                                const std::unordered_set<std::string_view>& known) {
    const std::string what = "$" + variable.name;
    if (in_collection)
        return what + " has no value here: a collection has no parameters; write a value";
    constexpr std::size_t most_compared = 50;
    if (known.empty() || known.size() > most_compared)
        return what + " is no parameter of this form; declare it as vars(" + what + "=value)";
    const std::vector<std::string> names(known.begin(), known.end());
    return what + " is no parameter of this form; write $" + nearestWord(variable.name, names) +
           " or declare it as vars(" + what + "=value)";
}

void checkVariables(const Plan& plan, const FormIndex& index, Findings& findings) {
    for (std::size_t i = 0; i < plan.forms.size(); ++i) {
        const bool in_collection = std::holds_alternative<Collection>(plan.forms[i]);
        forEachCall(plan.forms[i], [&](const Call& call, bool) {
            for (const Argument& argument : call.arguments) {
                const auto* const variable = std::get_if<Variable>(&argument.value);
                if (variable && !index.declares(i, variable->name))
                    findings.push_back({Code::FreeVariable, variable->at,
                                        freeVariableMessage(*variable, in_collection, index.formals(i)), std::nullopt});
            }
        });
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
