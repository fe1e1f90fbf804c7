#include "core/posh/form_index.h"

#include "core/posh/plan_walk.h"

namespace usar::posh {

FormIndex::FormIndex(const Plan& plan) : formals_(plan.forms.size()) {
    forms_.reserve(plan.forms.size());
    for (std::size_t i = 0; i < plan.forms.size(); ++i) {
        if (!std::holds_alternative<Collection>(plan.forms[i]))
            forms_.emplace(nameOf(plan.forms[i]).text, i);
        for (const Formal& formal : formalsOf(plan.forms[i]))
            formals_[i].insert(formal.variable.name);
    }
    for (std::size_t i = 0; i < plan.forms.size(); ++i)
        forEachCall(plan.forms[i], [&](const Call& call, bool is_sense) {
            if (const auto target = is_sense ? std::nullopt : find(call.name.text))
                references_.push_back({&call, i, *target});
        });
}

std::optional<std::size_t> FormIndex::find(std::string_view name) const {
    const auto found = forms_.find(name);
    return found == forms_.end() ? std::nullopt : std::optional(found->second);
}

} // namespace usar::posh
