// Where a leg of two links puts its foot: for whatever makes a legged robot walk, a behavior or a person's stick.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace usar::agent {

/// Lengths of the two links of a leg, in meters.
struct LegLinks {
    double thigh_m = 0.0;
    double shin_m = 0.0;
};
/// The four legs of an ERS-7 have the same links.
inline constexpr LegLinks ers_leg{0.071, 0.072};
/// The joints of an ERS's legs as the embedded simulator's file names them (robots-and-worlds.md 3.4); those in UT2004
/// are unknown. Legs: left front, right front, left hind, right hind; of each the hip, the spread and the knee.
inline constexpr std::array<std::array<std::string_view, 3>, 4> ers_leg_joints{{{"LFLeg1", "LFLeg2", "LFLeg3"},
                                                                                {"RFLeg1", "RFLeg2", "RFLeg3"},
                                                                                {"LHLeg1", "LHLeg2", "LHLeg3"},
                                                                                {"RHLeg1", "RHLeg2", "RHLeg3"}}};

/// Both are 0 if the leg points straight down. A positive hip swings the thigh forward; a positive knee bends the shin
/// backward.
struct LegAngles {
    double hip_rad = 0.0;
    double knee_rad = 0.0;
};
/// The angles that put the foot at this place, measured from the hip in the plane of the leg. The knee is in front of
/// the line from hip to foot. If the place is too far away, the leg points straight toward it.
inline LegAngles legAngles(const LegLinks& links, double forward_m, double down_m) {
    // Thigh, shin and the line from hip to foot form a triangle, from which the angle of the knee follows.
    const auto [thigh_m, shin_m] = links;
    const double square_m2 = forward_m * forward_m + down_m * down_m;
    const double cosine = (square_m2 - thigh_m * thigh_m - shin_m * shin_m) / (2.0 * thigh_m * shin_m);
    const double knee_rad = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double ahead_of_foot_rad = std::atan2(shin_m * std::sin(knee_rad), thigh_m + shin_m * std::cos(knee_rad));
    return {std::atan2(forward_m, down_m) + ahead_of_foot_rad, knee_rad};
}

} // namespace usar::agent
