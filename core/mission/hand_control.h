// Which of a person's hands drives, and since when it has not been heard of.
#pragma once

#include <array>
#include <optional>

#include "core/base/clock.h"
#include "core/mission/control_state.h"

namespace usar::mission {

/// Rules: nothing drives until the person has taken control. The first hand that moves has the robot until it is let
/// go; another one meanwhile is not heard, nor later before it was let go once. So it is with every hand that was held
/// when something else ended its hold: it has to be let go before it counts again. Wall time is an argument; a value.
class HandControl {
public:
    enum class Verdict { Ignored, Held, Released };

    /// The person has taken control, or gave it back.
    void setOn(bool on);
    bool on() const { return on_; }
    Verdict accept(const HandIntent& intent, Seconds wall);
    /// Ends the hold, whoever holds.
    void letGo();
    /// A dead man's hand: it holds, and was silent for longer than `patience`.
    bool overdue(Seconds wall, Seconds patience) const;
    bool holding() const { return holder_.has_value(); }
    /// What is held; nothing while nobody does.
    const std::optional<HandIntent>& holder() const { return holder_; }

private:
    struct Hand {
        bool moved = false; ///< by its last word
        bool spent = false; ///< has to be let go before it counts again
    };

    std::array<Hand, 3> hands_;
    std::optional<HandIntent> holder_;
    Seconds last_word_{0.0};
    bool on_ = false;
};

} // namespace usar::mission
