// The one place where the protocol's frame meets ours. The wire is x forward, y RIGHT, z DOWN, yaw clockwise and a
// positive pitch lifts the nose; inside we follow REP-103 (see core/base/geometry.h). The two differ by half a turn
// about x: y, z, pitch and yaw change sign, x and roll stay (usarsim-protocol 3). Its own inverse.
#pragma once

#include "core/base/geometry.h"

namespace usar::protocol {

/// Position as the wire says it, in metres, to the map frame; and back, for the conversion is its own inverse.
Vec3 acrossWire(const Vec3& position_m);
/// A pose; the resulting angles are normalised to (-pi, pi].
Pose acrossWire(const Pose& pose);
/// Yaw, yaw rate, or a sideways velocity (the wire's positive is right, ours is left).
constexpr double acrossWire(double yaw_or_sideways) {
    return -yaw_or_sideways;
}

} // namespace usar::protocol
