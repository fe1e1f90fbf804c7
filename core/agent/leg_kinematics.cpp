#include "core/agent/leg_kinematics.h"

#include <algorithm>
#include <cmath>

namespace usar::agent {

/// Thigh, shin and the line from hip to foot form a triangle, from which the angle of the knee follows.
LegAngles legAngles(const LegLinks& links, double forward_m, double down_m) {
    const auto [thigh_m, shin_m] = links;
    const double square_m2 = forward_m * forward_m + down_m * down_m;
    const double cosine = (square_m2 - thigh_m * thigh_m - shin_m * shin_m) / (2.0 * thigh_m * shin_m);
    const double knee_rad = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double ahead_of_foot_rad = std::atan2(shin_m * std::sin(knee_rad), thigh_m + shin_m * std::cos(knee_rad));
    return {std::atan2(forward_m, down_m) + ahead_of_foot_rad, knee_rad};
}

} // namespace usar::agent
