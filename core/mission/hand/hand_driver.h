// Drives one robot by hand: turns the intents of input devices into commands, and asks the robot how it is driven.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/mission/hand/control_state.h"
#include "core/mission/hand/stick_drive.h"
#include "core/mission/hand/walking_gait.h"
#include "core/modules/query.h"

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

/// Belongs to one session and its thread. It has no clock: wall time and protocol time are arguments. Commands are
/// returned for the session to send.
class HandDriver {
public:
    using Commands = std::vector<protocol::Command>;

    /// Forgets the robot and ends any control by hand.
    void beginConnection() { *this = {}; }
    /// Learns from one message of the connection.
    void take(const protocol::InfoLine& line);
    /// Question to send to the robot now; nullopt if there is none. One at a time; `now` is the protocol clock.
    std::optional<protocol::Command> question(Seconds now);

    /// On: the user takes control, and the robot is asked how it is driven. Off: the user gives control back.
    void setOn(bool on);
    bool on() const { return hands_.on(); }
    bool holding() const { return hands_.holding(); }
    /// Name of the device that moves the robot: "keys", "gamepad Xbox Controller", or "nobody".
    std::string holderText() const;

    /// Takes the current state of one input device; axes that the robot cannot follow count as 0.
    HandControl::Verdict accept(const HandIntent& intent, Seconds wall);
    /// True if the driving device has been silent for longer than `patience` (wall time).
    bool overdue(Seconds wall, Seconds patience) const { return hands_.overdue(wall, patience); }
    /// Advances by `dt` of wall time; returns the command to send if the shaped stick or the speed share has changed.
    Commands advance(Seconds dt);
    /// To be called when the server's clock ticks: repeats what is held, and makes legs step.
    Commands repeat(Seconds now);
    /// Ends the hold, whichever device has it, and returns the commands that bring the robot to rest. Devices must be
    /// released before they count again. `reason` is shown as ControlState::last_stop.
    Commands stop(const std::string& reason);

    /// The control state except for the behavior, of which this object knows nothing.
    ControlState state() const;

private:
    Commands driveNow() const;
    double speedShare() const { return hands_.holder() ? hands_.holder()->speed_share : 0.0; }

    DriveLimits limits_;
    HandControl hands_;
    StickShaper shaper_;
    WalkingGait gait_;
    modules::ConfigurationModule configuration_;
    modules::GeometryModule geometry_;
    double said_share_ = 0.0; ///< speed share in the last command
    bool walked_ = false;     ///< steps were sent since it was last told to stand
    std::string last_stop_;
};

} // namespace usar::mission
