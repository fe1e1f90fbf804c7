// Lets a camera look around: pans and tilts it within the limits of its mount, and zooms.
#pragma once

#include <optional>

#include "core/base/clock.h"
#include "core/protocol/command.h"
#include "robots/submarine/limits.h"

namespace usar::submarine {

/// Pans back and forth, tilts three times as often, and narrows the field of view as it tilts down. Returns at most
/// one command per call, MISPKG and SET in turn, because a server accepts one SET per tick.
class CameraSweep {
public:
    /// Returns the next command, at most every half second; nullopt if none is due or possible. `now` is the time of
    /// the protocol clock; `half` is the time from one side to the other, which is extended if the mount is too slow
    /// for it.
    std::optional<protocol::Command> next(Seconds now, Seconds half, const Limits& limits);

private:
    std::optional<protocol::Command> move(const protocol::PackageConfiguration& mount) const;
    std::optional<protocol::Command> zoom(const protocol::CameraConfiguration& camera) const;

    std::optional<Seconds> last_; ///< time of the last command
    double phase_ = 0.0;          ///< number of complete sweeps (there and back) of the pan
    int turn_ = 0;                ///< 1: the last command was for the mount; 0: for the zoom
};

} // namespace usar::submarine
