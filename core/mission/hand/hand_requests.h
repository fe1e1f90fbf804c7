// The user's side of driving by hand: the request for control, and the motion that each input device requests.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/mission/hand/control_state.h"

namespace usar::mission {

/// Keeps what the user requests from the session, which decides who drives (hand_control.h), and how long to wait for
/// its answer. A plain value without a clock: callers pass the wall time.
class HandRequests {
public:
    static constexpr std::array sources{HandSource::Keys, HandSource::Pad, HandSource::Gamepad};
    /// Longest time in which a session may leave a request for control unanswered.
    static constexpr Seconds patience{1.0};

    /// Requests control, perhaps again. Returns true if the user had neither requested it nor had it before.
    bool take(Seconds wall);
    /// Gives control back, by the user's choice or because the robot can no longer be driven. Returns true if control
    /// was requested or held until now.
    bool giveBack();
    /// True if the user has requested control or has it.
    bool taken() const { return taken_; }
    /// Takes the session's newest report of who drives. Returns true if the user's control ends now: the session had
    /// confirmed it and has taken it away, or did not confirm it in time.
    [[nodiscard]] bool hear(Reins reins, Seconds wall);

    /// Stores a device's new deflection. Returns true if the session must be told at once: the user has taken control,
    /// or the device was released.
    [[nodiscard]] bool move(HandSource source, const Stick& stick);
    /// True if the device is deflected.
    bool isHeld(HandSource source) const { return !stick(source).centered(); }
    /// Returns the deflected devices, whose intents have to be repeated.
    std::vector<HandSource> held() const;
    /// Returns the intent to send to the session for one device. `gamepad`: name of the gamepad that is plugged in;
    /// `speed_share`: see HandIntent.
    HandIntent intentOf(HandSource source, const std::string& gamepad, double speed_share) const;

private:
    const Stick& stick(HandSource source) const { return sticks_[static_cast<std::size_t>(source)]; }

    std::array<Stick, sources.size()> sticks_; ///< indexed by source
    Seconds asked_at_{0.0};                    ///< wall time of the newest request
    bool taken_ = false;
    bool confirmed_ = false; ///< the session has confirmed the user's control
};

} // namespace usar::mission
