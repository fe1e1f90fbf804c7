// The body of the ERS: converts places of paws to the joint angles of a MULTIDRIVE.
#pragma once

#include <array>

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

} // namespace usar::ers
