// What one session sends to its server: commands in the server's dialect, and DRIVEs at the rate that it can take.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/mission/session/drive_gate.h"
#include "core/mission/session/safe_stop.h"
#include "core/protocol/dialect_detector.h"
#include "core/protocol/info/robot_state.h"

namespace usar::mission {

/// Keeps which DRIVEs wait, which dialect the server speaks, and what was set in motion. Writes to its writer at once,
/// during the calls; times are on the protocol clock. Belongs to one session and its thread.
class Outgoing {
public:
    /// Takes a command and its line, without line end.
    using Writer = std::function<void(const agent::CausedCommand& command, std::string text)>;
    explicit Outgoing(Writer writer) : writer_(std::move(writer)) {}

    /// Forgets the server and the robot, and the DRIVEs that wait.
    void beginConnection();
    /// Every line of the server tells something about its dialect.
    void heard(std::string_view line) { dialect_.take(line); }
    /// A command that was sent by somebody else, as in a replay.
    void sawSent(const protocol::Command& command) { dialect_.sent(command); }
    /// Absent until the server has shown it.
    std::optional<protocol::Dialect> dialect() const { return dialect_.dialect(); }
    /// The dialect in which commands are written: as for UT2004 until another one is known.
    protocol::Dialect spelling() const { return dialect().value_or(protocol::Dialect::Ut2004); }

    /// Writes the command; a DRIVE waits until it is released, and replaces an older one that still waits.
    void send(const agent::CausedCommand& command);
    /// Writes the DRIVEs that wait, if the last ones are long enough ago.
    void release(Seconds now);
    /// Writes the DRIVEs that wait.
    void releaseNow(Seconds now);
    void dropWaiting() { gate_.reset(); }

    /// Commands that bring the robot to rest: a zero DRIVE for its kind, unless the behavior has a safe command of its
    /// own, and commands that stop everything else that was set in motion.
    std::vector<protocol::Command> stops(const std::optional<protocol::Command>& safe,
                                         protocol::VehicleKind kind) const;
    /// DRIVEs of this connection that newer ones replaced before they were sent.
    std::uint64_t drivesReplaced() const { return drives_replaced_; }

private:
    void write(const agent::CausedCommand& command);

    Writer writer_;
    DriveGate gate_;
    MovingParts moving_;
    protocol::DialectDetector dialect_;
    std::uint64_t drives_replaced_ = 0;
};

} // namespace usar::mission
