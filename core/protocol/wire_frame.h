// The only conversion between the protocol's frame and ours. On the wire x is forward, y RIGHT, z DOWN, yaw clockwise,
// and a positive pitch lifts the nose; internally we follow REP-103 (see core/base/geometry.h). The two frames differ
// by half a turn about x: y, z, pitch and yaw change sign, x and roll do not (protocol.md 3). The conversion is
// its own inverse.
#pragma once

#include "core/base/geometry.h"

namespace usar::protocol {

/// Converts a position or direction from the wire's frame to ours, or back: (x, y, z) becomes (x, -y, -z).
inline Vec3 acrossWire(const Vec3& position_m) {
    return {position_m.x(), -position_m.y(), -position_m.z()};
}
/// Converts a pose; the resulting angles are normalized to (-pi, pi].
inline Pose acrossWire(const Pose& pose) {
    return {acrossWire(pose.position_m), normalizedAngle(pose.roll_rad), normalizedAngle(-pose.pitch_rad),
            normalizedAngle(-pose.yaw_rad)};
}
/// Converts a yaw angle, a yaw rate or a sideways velocity (positive is right on the wire, left for us).
constexpr double acrossWire(double yaw_or_sideways) {
    return -yaw_or_sideways;
}

/// Roll, pitch and yaw in rad, as servers list them.
inline Vec3 anglesOf(const Pose& pose) {
    return {pose.roll_rad, pose.pitch_rad, pose.yaw_rad};
}

} // namespace usar::protocol
