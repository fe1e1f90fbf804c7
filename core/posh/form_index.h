// Which name means which competence, pattern or adopt of a plan, and who calls them.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "core/posh/number_table.h"
#include "core/posh/plan.h"

namespace usar::posh {

/// A call of a competence, pattern or adopt.
struct Reference {
    const Call* call = nullptr;
    std::size_t form = 0; ///< where it stands, as an index in Plan::forms
    std::size_t target = 0;
};

/// A variable among the arguments of a call.
struct VariableUse {
    const Variable* variable = nullptr;
    std::size_t form = 0; ///< where it stands
};

/// The plan must outlive it. Of two forms with one name the first counts.
class FormIndex {
public:
    explicit FormIndex(const Plan& plan);

    /// Index in Plan::forms; nothing for primitives and for the collection.
    std::optional<std::size_t> find(std::string_view name) const;
    /// In the order of the text.
    const std::vector<Reference>& references() const { return references_; }
    /// Likewise, whether declared or not.
    const std::vector<VariableUse>& variables() const { return variables_; }
    bool declares(std::size_t form, std::string_view parameter) const { return formals_[form].contains(parameter); }
    const std::unordered_set<std::string_view>& formals(std::size_t form) const { return formals_[form]; }

private:
    auto nameOfForm() const {
        return [this](std::size_t form) -> const std::string& { return nameOf(plan_->forms[form]).text; };
    }

    const Plan* plan_;
    NumberTable forms_;
    std::vector<std::unordered_set<std::string_view>> formals_;
    std::vector<Reference> references_;
    std::vector<VariableUse> variables_;
};

} // namespace usar::posh
