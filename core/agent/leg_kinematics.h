// Where a leg of two links puts its foot: for whatever makes a legged robot walk, a behavior or a person's stick.
#pragma once

namespace usar::agent {

/// Lengths of the two links of a leg, in meters.
struct LegLinks {
    double thigh_m = 0.0;
    double shin_m = 0.0;
};
/// The four legs of an ERS-7 have the same links.
inline constexpr LegLinks ers_leg{0.071, 0.072};

/// Both are 0 if the leg points straight down. A positive hip swings the thigh forward; a positive knee bends the shin
/// backward.
struct LegAngles {
    double hip_rad = 0.0;
    double knee_rad = 0.0;
};
/// The angles that put the foot at this place, measured from the hip in the plane of the leg. The knee is in front of
/// the line from hip to foot. If the place is too far away, the leg points straight toward it.
LegAngles legAngles(const LegLinks& links, double forward_m, double down_m);

} // namespace usar::agent
