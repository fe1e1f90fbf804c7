// The ERS's body as MULTIDRIVE names it: where a paw is put, and how the joints of its leg stand then.
#pragma once

#include <array>

#include "core/protocol/command.h"

namespace usar::ers {

enum class Leg { LeftFront, RightFront, LeftHind, RightHind };
inline constexpr std::array all_legs{Leg::LeftFront, Leg::RightFront, Leg::LeftHind, Leg::RightHind};

constexpr bool isLeft(Leg leg) {
    return leg == Leg::LeftFront || leg == Leg::LeftHind;
}
/// Legs on a diagonal step together in a trot.
constexpr bool onFirstDiagonal(Leg leg) {
    return leg == Leg::LeftFront || leg == Leg::RightHind;
}

/// Of the middle of a paw, from its hip: forward, and down. Metres.
struct PawPlace {
    double forward_m = 0.0;
    double down_m = 0.0;
    bool operator==(const PawPlace&) const = default;
};
/// As a spawned robot stands, its legs straight.
inline constexpr PawPlace straight_down{0.0, 0.143};
/// As it walks and waits: knees bent, paws a little in front, for the head weighs on them.
inline constexpr PawPlace standing_paw{0.015, 0.11};

/// Adds the targets of the leg's three joints. A place out of reach becomes a straight leg toward it.
void putPaw(protocol::MultiDrive& drive, Leg leg, const PawPlace& paw);
/// Adds the targets of the head's joints; `down_rad` is 0 for a head that looks straight ahead.
void bowHead(protocol::MultiDrive& drive, double down_rad);
/// The head can bow so far.
inline constexpr double deepest_bow_rad = 1.2;

} // namespace usar::ers
