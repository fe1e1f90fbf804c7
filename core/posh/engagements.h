// How long competences have been visited without a break, and how often their elements started meanwhile.
#pragma once

#include <vector>

#include "core/posh/tracer.h"

namespace usar::posh {

class Engagements {
public:
    explicit Engagements(const Tracer& tracer) : tracer_(tracer) {}

    void load(const Program& program);
    /// Keeps what it knows; the program has the same shape.
    void retune(const Program& program) { program_ = &program; }
    /// Begins the engagement of a competence unless it has one.
    void visit(Index form);
    void end(Index form);
    /// Of all competences in a range of forms.
    void endWithin(Range forms);
    /// Those that were not visited in this cycle.
    void endUnvisited();
    void endAll();

    Milliseconds begin(Index form) const { return states_[form].begin; }
    std::uint64_t& starts(Index element) { return starts_[element]; }

private:
    struct State {
        Milliseconds begin{0};
        std::uint64_t visited = 0; ///< cycle
        bool engaged = false;
    };
    template <class Condition>
    void endWhere(Condition&& condition);

    const Tracer& tracer_;
    const Program* program_ = nullptr;
    std::vector<State> states_;         ///< by form
    std::vector<std::uint64_t> starts_; ///< by element
    std::vector<Index> engaged_;
};

} // namespace usar::posh
