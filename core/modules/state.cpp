#include "core/modules/state.h"

namespace usar::modules {

void StateModule::take(const protocol::InfoLine& line) {
    const auto* const state = std::get_if<protocol::RobotState>(&line.message);
    if (!state)
        return;
    latest_ = *state;
    line_ = line.number;
    if (state->time)
        takeTime(*state->time);
}

void StateModule::takeTime(Seconds time) {
    const auto follows = [time](Seconds earlier) { return time >= earlier && time - earlier <= jump_limit; };
    if (trust_ == Trust::None) {
        now_ = time;
        trust_ = Trust::First;
    } else if (follows(now_) || (doubted_ && follows(*doubted_))) {
        now_ = time;
        trust_ = Trust::Confirmed;
        doubted_.reset();
    } else if (time > now_ || (trust_ == Trust::First && now_ - time > jump_limit)) {
        doubted_ = time;
    } else {
        doubted_.reset();
    }
}

} // namespace usar::modules
