#include "core/mission/hand/hand_control.h"

namespace usar::mission {

std::string wordOf(HandSource source) {
    constexpr std::array words{"keys", "pad", "gamepad"};
    return words[static_cast<std::size_t>(source)];
}

void HandControl::setOn(bool on) {
    letGo();
    on_ = on;
}

HandControl::Verdict HandControl::accept(const HandIntent& intent, Seconds wall) {
    Hand& hand = hands_[static_cast<std::size_t>(intent.source)];
    const bool holds = holder_ && holder_->source == intent.source;
    hand.moved = !clamped(intent.stick).centered();
    if (!hand.moved) {
        hand.spent = false;
        if (!holds)
            return Verdict::Ignored;
        holder_.reset();
        return Verdict::Released;
    }
    if (!on_ || (holder_ && !holds))
        hand.spent = true;
    if (hand.spent)
        return Verdict::Ignored;
    holder_ = intent;
    last_word_ = wall;
    return Verdict::Held;
}

void HandControl::letGo() {
    holder_.reset();
    for (Hand& hand : hands_)
        hand.spent = hand.moved;
}

bool HandControl::overdue(Seconds wall, Seconds patience) const {
    return holder_ && wall - last_word_ > patience;
}

} // namespace usar::mission
