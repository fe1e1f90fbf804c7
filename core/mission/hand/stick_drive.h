// Makes a robot's DRIVE of the user's stick: smooths the stick, then converts it according to the robot's kind and
// limits.
#pragma once

#include <optional>

#include "core/base/clock.h"
#include "core/base/stick.h"
#include "core/mission/hand/drive_limits.h"
#include "core/protocol/command.h"

namespace usar::mission {

/// Highest yaw rate for driving by hand, in rad/s. Nobody steers well with more, and a P2DX could spin ten times a
/// second.
inline constexpr double most_yaw_rate_rad_s = 2.0;

/// Returns the DRIVE for this stick position, with every term of its kind, so that no earlier term stays in effect.
/// `speed_share` (0..1) scales speeds, but not the angles of wheels and fins. Terms are in physical units if the limits
/// are known, else in percent of the limits, which the server knows. If forward and turn together exceed the speed of
/// the wheels, a skid-steered robot keeps its curve and loses speed. Returns nullopt for an unknown style, and for a
/// walker, whose joints need a gait (walking_gait.h).
std::optional<protocol::Command> driveOf(const DriveLimits& limits, const Stick& stick, double speed_share);

/// Follows a stick: away from 0 by at most a full share per `rise`, toward 0 and through it at once. So a release stops
/// the robot, whatever came before. It has no clock of its own.
class StickShaper {
public:
    static constexpr Seconds rise{0.4};

    /// Returns the shaped position; `dt` is the time since the last call, which also limits the first one after a
    /// reset.
    Stick follow(const Stick& asked, Seconds dt);
    const Stick& now() const { return now_; }
    void reset() { now_ = {}; }

private:
    Stick now_;
};

} // namespace usar::mission
