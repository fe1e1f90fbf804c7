// Engagements of competences: since when each has been visited in every cycle, and how often its elements started.
#pragma once

#include <algorithm>
#include <vector>

#include "core/posh/run/tracer.h"

namespace usar::posh {

/// An engagement lasts as long as its competence is visited in each cycle without a break, even if the drive's stack is
/// rebuilt in between. Time limits and retries of competences count within one engagement.
class Engagements {
public:
    /// The tracer must outlive this object.
    explicit Engagements(const Tracer& tracer) : tracer_(tracer) {}

    /// Resets everything and reserves all memory that a run of the tracer's program needs.
    void load() {
        const Program& program = *tracer_.program();
        states_.assign(program.forms.size(), {});
        starts_.assign(program.elements.size(), 0);
        engaged_.clear();
        engaged_.reserve(program.forms.size());
    }
    /// Marks a competence as visited in this cycle; begins its engagement if it has none.
    void visit(Index form) {
        State& state = states_[form];
        state.visited = tracer_.cycle();
        if (state.engaged)
            return;
        state.engaged = true;
        state.begin = tracer_.now();
        engaged_.push_back(form);
        const Range elements = tracer_.program()->forms[form].items;
        std::fill(starts_.begin() + elements.first, starts_.begin() + elements.end, 0);
    }
    /// Ends the engagement of one competence; does nothing if it has none.
    void end(Index form) {
        endWhere([form](Index engaged) { return engaged == form; });
    }
    /// Ends the engagements of all competences in a range of forms.
    void endWithin(Range forms) {
        endWhere([forms](Index engaged) { return forms.contains(engaged); });
    }
    /// Ends the engagements of all competences that were not visited in this cycle.
    void endUnvisited() {
        endWhere([this](Index engaged) { return states_[engaged].visited != tracer_.cycle(); });
    }
    /// Ends all engagements, as when a run stops.
    void endAll() {
        endWhere([](Index) { return true; });
    }

    /// The host time at which the engagement of a competence began. The competence must be engaged.
    Milliseconds begin(Index form) const { return states_[form].begin; }
    /// How often an element has started in the engagement of its competence; the caller counts it up.
    std::uint64_t& starts(Index element) { return starts_[element]; }

private:
    /// The engagement of one competence.
    struct State {
        Milliseconds begin{0};
        std::uint64_t visited = 0; ///< number of the last cycle that visited it
        /// The other members count only if this is true.
        bool engaged = false;
    };
    /// Ends the engagements for which the condition holds; its cost grows with the number of engagements.
    template <class Condition>
    void endWhere(Condition&& condition) {
        std::erase_if(engaged_, [&](Index form) {
            if (!condition(form))
                return false;
            states_[form].engaged = false;
            return true;
        });
    }

    const Tracer& tracer_;
    std::vector<State> states_;         ///< indexed by form
    std::vector<std::uint64_t> starts_; ///< indexed by element
    std::vector<Index> engaged_;        ///< forms with an engagement
};

} // namespace usar::posh
