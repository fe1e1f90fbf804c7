// Which of the user's input devices drives, and how long ago it was last heard from.
#pragma once

#include <array>
#include <optional>

#include "core/base/clock.h"
#include "core/mission/hand/control_state.h"

namespace usar::mission {

/// Nothing drives until the user has taken control. The first device that moves has the robot until it is released;
/// another one that moves meanwhile is ignored, until it has been released once. The same holds for every device that
/// was held when something else ended its hold: it must be released before it counts again. Wall time is an argument; a
/// value.
class HandControl {
public:
    /// Ignored: the intent changes nothing. Held: it drives now. Released: it has ended its own hold.
    enum class Verdict { Ignored, Held, Released };

    /// Takes control or gives it back. Either way the current hold ends.
    void setOn(bool on);
    bool on() const { return on_; }
    /// Takes the current state of one device; `wall` is wall time.
    Verdict accept(const HandIntent& intent, Seconds wall);
    /// Ends the hold, whichever device has it. Devices that are still held must be released before they count again.
    void letGo();
    /// Dead man's switch: true if a device holds the robot and has been silent for longer than `patience`.
    bool overdue(Seconds wall, Seconds patience) const;
    bool holding() const { return holder_.has_value(); }
    /// Newest intent of the device that drives; nullopt while none does.
    const std::optional<HandIntent>& holder() const { return holder_; }

private:
    struct Hand {
        bool moved = false; ///< in its newest intent
        bool spent = false; ///< must be released before it counts again
    };

    std::array<Hand, 3> hands_;
    std::optional<HandIntent> holder_;
    Seconds last_word_{0.0};
    bool on_ = false;
};

} // namespace usar::mission
