#include "core/posh/language/form_index.h"

#include "core/posh/model/plan_walk.h"

namespace usar::posh {

FormIndex::FormIndex(const Plan& plan) : plan_(&plan), formals_(plan.forms.size()) {
    forms_.reserve(plan.forms.size());
    for (std::size_t i = 0; i < plan.forms.size(); ++i) {
        if (!std::holds_alternative<Collection>(plan.forms[i]))
            forms_.findOrNote(nameOf(plan.forms[i]).text, static_cast<NumberTable::Number>(i), nameOfForm());
        for (const Formal& formal : formalsOf(plan.forms[i]))
            formals_[i].insert(formal.variable.name);
    }
    for (std::size_t i = 0; i < plan.forms.size(); ++i)
        forEachCall(plan.forms[i], [&](const Call& call, bool is_sense) {
            for (const Argument& argument : call.arguments)
                if (const auto* const variable = std::get_if<Variable>(&argument.value))
                    variables_.push_back({variable, i});
            if (const auto target = is_sense ? std::nullopt : find(call.name.text))
                references_.push_back({&call, i, *target});
        });
}

std::optional<std::size_t> FormIndex::find(std::string_view name) const {
    const NumberTable::Number found = forms_.find(name, nameOfForm());
    return found == NumberTable::none ? std::nullopt : std::optional<std::size_t>(found);
}

} // namespace usar::posh
