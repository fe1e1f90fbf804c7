// Output of one session to its server: commands in the server's dialect, and DRIVEs at a rate that it can handle.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/mission/commands/drive_gate.h"
#include "core/mission/commands/safe_stop.h"
#include "core/protocol/dialect_detector.h"
#include "core/protocol/info/robot_state.h"

namespace usar::mission {

/// Tracks the waiting DRIVEs, the server's dialect, and the parts set in motion. Calls its writer directly, before a
/// function returns; times are on the protocol clock. Belongs to one session and its thread.
class Outgoing {
public:
    /// Takes a command and its line, without line end.
    using Writer = std::function<void(const agent::CausedCommand& command, std::string text)>;
    explicit Outgoing(Writer writer) : writer_(std::move(writer)) {}

    /// Forgets the server, the robot and the waiting DRIVEs.
    void beginConnection();
    /// Takes a line from the server to detect its dialect; to be called with every line.
    void heard(std::string_view line) { dialect_.take(line); }
    /// Takes a command that was not sent by this object, as in a replay.
    void sawSent(const protocol::Command& command) { dialect_.sent(command); }
    /// The detected dialect; nullopt until it is known.
    std::optional<protocol::Dialect> dialect() const { return dialect_.dialect(); }
    /// The dialect in which commands are written: that of UT2004 until another is detected.
    protocol::Dialect spelling() const { return dialect().value_or(protocol::Dialect::Ut2004); }

    /// Writes the command; a DRIVE waits until it is released, and replaces an older one that still waits.
    void send(const agent::CausedCommand& command);
    /// Writes the waiting DRIVEs if enough time has passed since the last ones, or, with `at_once`, in any case.
    void release(Seconds now, bool at_once = false);
    void dropWaiting() { gate_.reset(); }

    /// Commands that bring the robot to rest: a zero DRIVE for its kind, unless the behavior has a safe command of its
    /// own, and commands that stop everything else that was set in motion.
    std::vector<protocol::Command> stops(const std::optional<protocol::Command>& safe,
                                         protocol::VehicleKind kind) const;
    /// Number of DRIVEs on this connection that newer ones replaced before they were sent.
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
