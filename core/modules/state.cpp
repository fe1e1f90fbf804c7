#include "core/modules/state.h"

#include <algorithm>

namespace usar::modules {

void StateModule::take(const protocol::InfoLine& line) {
    const auto* const state = std::get_if<protocol::RobotState>(&line.message);
    if (!state)
        return;
    latest_ = *state;
    line_ = line.number;
    if (state->time)
        now_ = std::max(now_, *state->time);
}

} // namespace usar::modules
