// An open-loop trot for the four legs of an ERS, so that a hand can drive a robot that only knows its joints.
#pragma once

#include <optional>
#include <span>

#include "core/base/clock.h"
#include "core/base/stick.h"
#include "core/protocol/commands/joint.h"
#include "core/protocol/info/robot_state.h"

namespace usar::mission {

/// MULTIDRIVE by MULTIDRIVE, one a step of the server's clock. First it bends its knees, in five steps; then legs on a
/// diagonal lift, swing forward and push back while the other two do so. Turning makes the steps of one side longer
/// than those of the other. Angles are of an ERS-7: hips and knees turn forward by positive angles. A value; time is an
/// argument.
class WalkingGait {
public:
    /// Two steps of a leg are at least this far apart, by the protocol's clock.
    static constexpr Seconds step_time{0.2};

    /// Whether these are the joints that it moves.
    static bool fits(std::span<const protocol::JointAngle> joints);

    /// The next step, if it is due; `stick` and share as for driveOf.
    std::optional<protocol::MultiDrive> step(const Stick& stick, double speed_share, Seconds now);
    /// All feet on the ground below the hips, or as far as the knees are bent: what stops it in the middle of a step.
    protocol::MultiDrive stand() const;
    /// Its legs may be anywhere: the knees are bent anew before the next step.
    void reset() { *this = {}; }

private:
    void place(protocol::MultiDrive& drive, std::string_view leg, double x_m, double z_m) const;

    double bent_ = 0.0; ///< 0 upright .. 1 ready to walk
    int beat_ = 0;
    std::optional<Seconds> last_;
};

} // namespace usar::mission
