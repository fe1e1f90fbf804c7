// A trot: the legs on one diagonal step forward while those on the other push the body over the ground.
#pragma once

#include <optional>

#include "core/base/clock.h"
#include "robots/ers/legs.h"

namespace usar::ers {

/// How far the paws of each side step, metres; negative backward. Both 0: the robot stands.
struct Strides {
    double left_m = 0.0;
    double right_m = 0.0;
    bool operator==(const Strides&) const = default;
};

/// One set of targets each 0.2 s, which is how often a robot of UT2004 listens: a paw is lifted through the middle, set
/// down in front, and pushed back in two moves. Two paws are on the ground at every moment, and four at every other.
class Gait {
public:
    /// Bends the knees first, slowly: at once the robot would fall on its nose. Then walks. False: not yet time for the
    /// next move.
    bool next(Seconds now, const Strides& strides, double lift_m, protocol::MultiDrive& drive);
    bool standing() const { return risen_ >= moves_to_rise; }
    /// It fell over, and begins anew.
    void reset() { *this = {}; }

private:
    static constexpr int moves_to_rise = 8;

    std::optional<Seconds> moved_at_;
    int risen_ = 0; ///< moves
    int move_ = 0;  ///< of the trot
};

} // namespace usar::ers
