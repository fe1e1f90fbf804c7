#include "core/posh/run/engagements.h"

#include <algorithm>

namespace usar::posh {

void Engagements::load(const Program& program) {
    program_ = &program;
    states_.assign(program.forms.size(), {});
    starts_.assign(program.elements.size(), 0);
    engaged_.clear();
    engaged_.reserve(program.forms.size());
}

void Engagements::visit(Index form) {
    State& state = states_[form];
    state.visited = tracer_.cycle();
    if (state.engaged)
        return;
    state.engaged = true;
    state.begin = tracer_.now();
    engaged_.push_back(form);
    const Range elements = program_->forms[form].items;
    std::fill(starts_.begin() + elements.first, starts_.begin() + elements.end, 0);
}

template <class Condition>
void Engagements::endWhere(Condition&& condition) {
    std::erase_if(engaged_, [&](Index form) {
        if (!condition(form))
            return false;
        states_[form].engaged = false;
        return true;
    });
}

void Engagements::end(Index form) {
    endWhere([form](Index engaged) { return engaged == form; });
}

void Engagements::endWithin(Range forms) {
    endWhere([forms](Index engaged) { return forms.contains(engaged); });
}

void Engagements::endUnvisited() {
    endWhere([this](Index engaged) { return states_[engaged].visited != tracer_.cycle(); });
}

void Engagements::endAll() {
    endWhere([](Index) { return true; });
}

} // namespace usar::posh
