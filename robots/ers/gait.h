// A trot: the legs on one diagonal step forward while those on the other push the body forward.
#pragma once

#include <optional>

#include "core/base/clock.h"
#include "robots/ers/legs.h"

namespace usar::ers {

/// The length of a step on each side, in meters; negative values are steps backward. If both are 0, the robot stands.
struct Strides {
    double left_m = 0.0;
    double right_m = 0.0;
    bool operator==(const Strides&) const = default;
};

/// Makes one move (a set of joint targets) every 0.2 s, which is how often a UT2004 robot takes commands. A step has
/// four moves: the paw is lifted through the middle, set down in front, and pushed back in two moves. At least two paws
/// are always on the ground, and all four at every other move.
class Gait {
public:
    /// Adds the joint targets of the next move to `drive`. First bends the knees slowly, because bending them at once
    /// would make the robot fall forward; then walks, lifting the paws by `lift_m`. Returns false and adds nothing if
    /// it is too early for the next move.
    bool next(Seconds now, const Strides& strides, double lift_m, protocol::MultiDrive& drive);
    /// Whether the robot has finished standing up.
    bool standing() const { return risen_ >= moves_to_rise; }
    /// Starts again with standing up, after a fall.
    void reset() { *this = {}; }

private:
    static constexpr int moves_to_rise = 8;

    std::optional<Seconds> moved_at_;
    int risen_ = 0; ///< number of moves made for standing up
    int move_ = 0;  ///< current move of the step, 0 to 3
};

} // namespace usar::ers
