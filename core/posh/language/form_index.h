// An index of a plan: its competences, patterns and adopts by name, their calls, and the variables in use.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "core/posh/model/number_table.h"
#include "core/posh/model/plan_walk.h"

namespace usar::posh {

/// A call of a competence, pattern or adopt.
struct Reference {
    const Call* call = nullptr;
    std::size_t form = 0;   ///< the form that contains the call, as an index in Plan::forms
    std::size_t target = 0; ///< the form that is called, as an index in Plan::forms
};

/// A variable among the arguments of a call.
struct VariableUse {
    const Variable* variable = nullptr;
    std::size_t form = 0; ///< the form that contains it, as an index in Plan::forms
};

/// The plan must outlive the index and must not change meanwhile. If two forms have the same name, the first one
/// counts.
class FormIndex {
    /// Gives the name table the name of a form by its index.
    auto nameOfForm() const {
        return [this](std::size_t form) -> const std::string& { return nameOf(plan_->forms[form]).text; };
    }

public:
    /// Visits the whole plan once. The collection cannot be called, so its name is not in the index.
    explicit FormIndex(const Plan& plan) : plan_(&plan), formals_(plan.forms.size()) {
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

    /// Returns an index in Plan::forms; nullopt for the name of a primitive or of the collection.
    std::optional<std::size_t> find(std::string_view name) const {
        const NumberTable::Number found = forms_.find(name, nameOfForm());
        return found == NumberTable::none ? std::nullopt : std::optional<std::size_t>(found);
    }
    /// All calls of forms, in the order of the text.
    const std::vector<Reference>& references() const { return references_; }
    /// All uses of variables, declared or not, in the order of the text.
    const std::vector<VariableUse>& variables() const { return variables_; }
    /// Returns whether the form has a parameter of that name (without the dollar sign).
    bool declares(std::size_t form, std::string_view parameter) const { return formals_[form].contains(parameter); }
    const std::unordered_set<std::string_view>& formals(std::size_t form) const { return formals_[form]; }

private:
    const Plan* plan_;
    NumberTable forms_;
    std::vector<std::unordered_set<std::string_view>> formals_;
    std::vector<Reference> references_;
    std::vector<VariableUse> variables_;
};

} // namespace usar::posh
