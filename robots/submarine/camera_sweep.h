// A camera that looks around: pans and tilts within the limits of its mount, and zooms as it moves.
#pragma once

#include <optional>

#include "core/base/clock.h"
#include "core/protocol/command.h"
#include "robots/submarine/limits.h"

namespace usar::submarine {

/// Pans to and fro and tilts three times as often; narrows its view the more it looks down. Gives at most one command
/// a call, MISPKG and SET in turn: a server takes one SET per tick.
class CameraSweep {
public:
    /// `now` on the protocol clock; `half` is the time from one side to the other.
    std::optional<protocol::Command> next(Seconds now, Seconds half, const Limits& limits);

private:
    std::optional<protocol::Command> move(const protocol::PackageConfiguration& mount) const;
    std::optional<protocol::Command> zoom(const protocol::CameraConfiguration& camera) const;

    std::optional<Seconds> last_;
    double phase_ = 0.0; ///< of the pan: whole numbers are whole sweeps to and fro
    int turn_ = 0;
};

} // namespace usar::submarine
