// Drives one robot by hand: turns the intents of input devices into commands, asks the robot how it is driven, and
// knows every reason for which a hold ends.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/cause.h"
#include "core/base/clock.h"
#include "core/mission/commands/drive_gate.h"
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
    bool overdue(Seconds wall, Seconds patience) const { return holder_ && wall - last_word_ > patience; }
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

/// Commands by hand, and the source that is named as the cause of each.
struct HandCommands {
    std::vector<protocol::Command> commands;
    by::Hand source;
};

/// Sends nothing itself, and reads no clock: wall times are arguments and count from any moment that stays the same;
/// `now` is the protocol clock. A plain value of one session.
class HandDriver {
public:
    /// Time between two beats of a hold (protocol.md 9.2: DRIVE no more often than about 20 Hz).
    static constexpr Seconds beat = DriveGate::spacing;

    /// Effect of a device's intent on the hold.
    enum class Change { None, Begins, Ends };

    /// Forgets the robot and ends any control by hand, but keeps the measured pace of the server.
    void beginConnection();
    /// Learns from one message of the connection.
    void take(const protocol::InfoLine& line);
    /// Measures the time between STA messages; to be called with each STA.
    void tick(Seconds wall);
    /// Asks the robot how it is driven, one question at a time.
    HandCommands question(Seconds now);

    /// On: the user takes control, and the robot is asked how it is driven. Off: the user gives control back.
    void setOn(bool on);
    bool on() const { return hands_.on(); }
    bool holding() const { return hands_.holding(); }
    /// The control state except for the behavior, of which this object knows nothing.
    ControlState state() const;

    /// Takes the current state of one input device; axes that the robot cannot follow count as 0. If it returns Ends,
    /// the device was let go and `stop` must be called.
    Change accept(const HandIntent& intent, Seconds wall);
    /// Returns why a hold must end now, as part of a sentence, or nullopt if it may continue. `patience` limits the
    /// device's silence; the limit for the robot grows with the time between its STA, because slow simulated time is
    /// not silence.
    std::optional<std::string> reasonToStop(Seconds wall, Seconds patience, std::optional<Seconds> robot_silent_for,
                                            const std::string& robot_name) const;

    /// To be called at each beat of a hold: the command to send if the shaped stick or the speed share has changed.
    HandCommands advance();
    /// To be called with each STA while the user has control: repeats what is held, and makes legs step.
    HandCommands repeat(Seconds now);
    /// Ends the hold, whichever device has it, and brings the robot to rest. Devices must be released before they count
    /// again. `reason` is shown as ControlState::last_stop.
    HandCommands stop(const std::string& reason);

private:
    /// The STA messages by wall time: the last one, and the time between the last two.
    struct Ticks {
        Seconds last{0.0};
        Seconds spacing{0.0};
    };

    HandCommands driveNow() const;
    /// The commands that the holder sends, with its name as their source.
    HandCommands byHolder(std::vector<protocol::Command> commands = {}) const;
    double speedShare() const { return hands_.holder() ? hands_.holder()->speed_share : 0.0; }

    DriveLimits limits_;
    HandControl hands_;
    StickShaper shaper_;
    WalkingGait gait_;
    modules::ConfigurationModule configuration_;
    modules::GeometryModule geometry_;
    Ticks ticks_;
    double said_share_ = 0.0; ///< speed share in the last command
    bool walked_ = false;     ///< steps were sent since it was last told to stand
    std::string last_stop_;
};

/// Returns the reason for an ending hold: "the keys were let go".
std::string lettingGo(HandSource source);

} // namespace usar::mission
