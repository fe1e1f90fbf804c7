#include "core/mission/hand/hand_requests.h"

namespace usar::mission {

bool HandRequests::take(Seconds wall) {
    asked_at_ = wall;
    if (taken_)
        return false;
    taken_ = true;
    confirmed_ = false;
    return true;
}

bool HandRequests::giveBack() {
    if (!taken_)
        return false;
    taken_ = false;
    confirmed_ = false;
    return true;
}

bool HandRequests::hear(Reins reins, Seconds wall) {
    if (reins == Reins::Hand) {
        confirmed_ = true;
        return false;
    }
    return taken_ && (confirmed_ || wall - asked_at_ > patience) && giveBack();
}

bool HandRequests::move(HandSource source, const Stick& stick) {
    sticks_[static_cast<std::size_t>(source)] = stick;
    return taken_ || stick.centered();
}

std::vector<HandSource> HandRequests::held() const {
    std::vector<HandSource> held;
    for (const HandSource source : sources)
        if (isHeld(source))
            held.push_back(source);
    return held;
}

HandIntent HandRequests::intentOf(HandSource source, const std::string& gamepad, double speed_share) const {
    return {source, source == HandSource::Gamepad ? gamepad : std::string(), stick(source), speed_share};
}

} // namespace usar::mission
