// Engagements of competences: since when each has been visited in every cycle, and how often its elements started.
#pragma once

#include <vector>

#include "core/posh/run/tracer.h"

namespace usar::posh {

/// An engagement lasts as long as its competence is visited in each cycle without a break, even if the drive's stack is
/// rebuilt in between. Time limits and retries of competences count within one engagement.
class Engagements {
public:
    /// The tracer must outlive this object.
    explicit Engagements(const Tracer& tracer) : tracer_(tracer) {}

    void load(const Program& program);
    /// Switches to a program of the same shape and keeps all engagements.
    void retune(const Program& program) { program_ = &program; }
    /// Marks a competence as visited in this cycle; begins its engagement if it has none.
    void visit(Index form);
    void end(Index form);
    /// Ends the engagements of all competences in a range of forms.
    void endWithin(Range forms);
    /// Ends the engagements of all competences that were not visited in this cycle.
    void endUnvisited();
    void endAll();

    /// The host time at which the engagement of a competence began. The competence must be engaged.
    Milliseconds begin(Index form) const { return states_[form].begin; }
    /// How often an element has started in the engagement of its competence; the caller counts it up.
    std::uint64_t& starts(Index element) { return starts_[element]; }

private:
    struct State {
        Milliseconds begin{0};
        std::uint64_t visited = 0; ///< number of the last cycle that visited it
        bool engaged = false;
    };
    template <class Condition>
    void endWhere(Condition&& condition);

    const Tracer& tracer_;
    const Program* program_ = nullptr;
    std::vector<State> states_;         ///< indexed by form
    std::vector<std::uint64_t> starts_; ///< indexed by element
    std::vector<Index> engaged_;        ///< forms with an engagement
};

} // namespace usar::posh
