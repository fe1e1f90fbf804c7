// The person's side of driving by hand: whether control was asked for, and what each input device asks.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/mission/hand/control_state.h"

namespace usar::mission {

/// The session decides who drives (hand_control.h); this is what the person asks of it, and how long its answer is
/// waited for. Wall time is an argument; a value.
class HandRequests {
public:
    static constexpr std::array sources{HandSource::Keys, HandSource::Pad, HandSource::Gamepad};
    /// Longest time in which a session may leave a request for control unanswered.
    static constexpr Seconds patience{1.0};

    /// The person asks for control, perhaps again. True if they had neither it nor asked for it.
    bool take(Seconds wall);
    /// The person gives control back, or the robot cannot be driven any more. True if it was asked for until now.
    bool giveBack();
    /// The person has asked for control, or has it.
    bool taken() const { return taken_; }
    /// Takes the session's newest word on who has the robot. True if the person's control ends with it: the session
    /// confirmed it and now has taken it away, or did not confirm it in time.
    [[nodiscard]] bool hear(Reins reins, Seconds wall);

    /// A device asks for something else. True if that is to be said at once: in control, or because it was let go.
    [[nodiscard]] bool move(HandSource source, const Stick& stick);
    /// True if the device asks for anything now.
    bool isHeld(HandSource source) const { return !stick(source).centered(); }
    /// The devices that ask for anything, and so have to say it again and again.
    std::vector<HandSource> held() const;
    /// What is said to the session for one device; `gamepad` is the name of the one that is plugged in.
    HandIntent intentOf(HandSource source, const std::string& gamepad, double speed_share) const;

private:
    const Stick& stick(HandSource source) const { return sticks_[static_cast<std::size_t>(source)]; }

    std::array<Stick, sources.size()> sticks_; ///< by source
    Seconds asked_at_{0.0};
    bool taken_ = false;
    bool confirmed_ = false; ///< by the session
};

} // namespace usar::mission
