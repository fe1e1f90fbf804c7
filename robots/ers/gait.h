// How the ERS moves its legs: joint angles for places of paws, and a trot, in which the legs on one diagonal step
// forward while those on the other push the body forward.
#pragma once

#include <array>
#include <optional>

#include "core/base/clock.h"
#include "core/protocol/command.h"

namespace usar::ers {

enum class Leg { LeftFront, RightFront, LeftHind, RightHind };
inline constexpr std::array all_legs{Leg::LeftFront, Leg::RightFront, Leg::LeftHind, Leg::RightHind};

constexpr bool isLeft(Leg leg) {
    return leg == Leg::LeftFront || leg == Leg::LeftHind;
}
/// Returns whether the leg is on the diagonal from the left front to the right hind leg. Legs on a diagonal step
/// together in a trot.
constexpr bool onFirstDiagonal(Leg leg) {
    return leg == Leg::LeftFront || leg == Leg::RightHind;
}

/// The place of the middle of a paw, measured from its hip. In meters.
struct PawPlace {
    double forward_m = 0.0;
    double down_m = 0.0;
    bool operator==(const PawPlace&) const = default;
};
/// The place of the paws of a newly spawned robot, whose legs are straight.
inline constexpr PawPlace straight_down{0.0, 0.143};
/// The place of the paws while the robot stands or is halfway through a step: the knees are bent, and the paws are
/// slightly in front because of the weight of the head.
inline constexpr PawPlace standing_paw{0.015, 0.11};

/// Adds the targets of the leg's three joints. If the place is out of reach, the leg points straight toward it.
void putPaw(protocol::MultiDrive& drive, Leg leg, const PawPlace& paw);
/// Adds the targets of the head's joints. `down_rad` is 0 when looking straight ahead, positive downward, and is
/// limited to 0 to deepest_bow_rad.
void bowHead(protocol::MultiDrive& drive, double down_rad);
/// The greatest angle by which the head can bow.
inline constexpr double deepest_bow_rad = 1.2;

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
