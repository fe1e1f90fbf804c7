#include "core/posh/language/plan_check.h"

#include <algorithm>
#include <string>
#include <vector>

namespace usar::posh {

namespace {

/// A depth-first search with an explicit stack, because a plan can be nested too deeply for recursion.
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

} // namespace

void checkReferenceCycles(const Plan& plan, const FormIndex& index, Findings& findings) {
    CycleSearch(plan, index).run(findings);
}

} // namespace usar::posh
