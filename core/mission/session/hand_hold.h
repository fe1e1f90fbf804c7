// Driving by hand in a session: what to send for the user, and every reason for which a hold ends.
#pragma once

#include <optional>
#include <string>

#include "core/mission/commands/drive_gate.h"
#include "core/mission/hand/hand_driver.h"

namespace usar::mission {

/// Manual driving commands and the source that is named as the cause of each.
struct HandCommands {
    HandDriver::Commands commands;
    by::Hand source;
};

/// Sends nothing itself, and reads no clock: wall times are arguments and count from any moment that stays the same.
/// A plain value of one session.
class HandHold {
public:
    /// Time between two beats of a hold (protocol.md 9.2: DRIVE no more often than about 20 Hz).
    static constexpr Seconds beat = DriveGate::spacing;

    /// Effect of a device's intent on the hold.
    enum class Change { None, Begins, Ends };

    /// Forgets the robot and ends any control by hand.
    void beginConnection() { driver_.beginConnection(); }
    void take(const protocol::InfoLine& line) { driver_.take(line); }
    /// Measures the time between STA messages; to be called with each STA.
    void tick(Seconds wall);

    void setOn(bool on) { driver_.setOn(on); }
    bool on() const { return driver_.on(); }
    bool holding() const { return driver_.holding(); }
    ControlState state() const { return driver_.state(); }

    /// Takes a device's intent. If it returns Ends, the device was let go and `stop` must be called.
    Change accept(const HandIntent& intent, Seconds wall);
    /// Returns why a hold must end now, as part of a sentence, or nullopt if it may continue. `patience` limits the
    /// device's silence; the limit for the robot grows with the time between its STA, because slow simulated time is
    /// not silence.
    std::optional<std::string> reasonToStop(Seconds wall, Seconds patience, std::optional<Seconds> robot_silent_for,
                                            const std::string& robot_name) const;

    /// Asks the robot how it is driven. `now` is the protocol clock here and in `repeat`.
    HandCommands question(Seconds now);
    /// To be called at each beat of a hold.
    HandCommands advance();
    /// To be called with each STA while the user has control.
    HandCommands repeat(Seconds now);
    /// Brings the robot to rest. Devices must be released before they count again.
    HandCommands stop(const std::string& reason);

private:
    HandDriver driver_;
    Seconds last_tick_{0.0};    ///< wall time of the last STA
    Seconds tick_spacing_{0.0}; ///< wall time between the last two STA
};

/// Returns the reason for an ending hold: "the keys were let go".
std::string lettingGo(HandSource source);

} // namespace usar::mission
