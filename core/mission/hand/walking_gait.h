// An open-loop trot for the four legs of an ERS, which makes a robot that only obeys its joints drivable by hand.
#pragma once

#include <optional>
#include <span>

#include "core/base/clock.h"
#include "core/base/stick.h"
#include "core/protocol/commands/joint.h"
#include "core/protocol/info/robot_state.h"

namespace usar::mission {

/// Produces one MULTIDRIVE per step on the server's clock. First the knees bend, in five steps; then two diagonal legs
/// lift, swing forward and push back while the other two do the opposite. Turning makes the steps of one side longer
/// than those of the other. Angles are for an ERS-7: positive angles turn hips and knees forward. A value; time is an
/// argument.
class WalkingGait {
public:
    /// Shortest time between two steps, on the protocol clock.
    static constexpr Seconds step_time{0.2};

    /// True if `joints` include all joints that the gait moves.
    static bool fits(std::span<const protocol::JointAngle> joints);

    /// Returns the next step if it is due, else nullopt; `stick` and `speed_share` as for driveOf, `now` on the
    /// protocol clock.
    std::optional<protocol::MultiDrive> step(const Stick& stick, double speed_share, Seconds now);
    /// Returns a stance with all feet on the ground under the hips, with the knees as bent as they are now. It stops
    /// the robot in the middle of a step.
    protocol::MultiDrive stand() const;
    /// For legs that may be anywhere: the knees bend again before the next step.
    void reset() { *this = {}; }

private:
    /// Adds the joints that put the foot of a leg (its place in agent::ers_leg_joints) at `x_m` (forward) and `z_m`
    /// (up) from its hip.
    void place(protocol::MultiDrive& drive, std::size_t leg, double x_m, double z_m) const;

    double bent_ = 0.0;           ///< 0 upright .. 1 ready to walk
    int beat_ = 0;                ///< number of steps so far
    std::optional<Seconds> last_; ///< time of the last step
};

} // namespace usar::mission
