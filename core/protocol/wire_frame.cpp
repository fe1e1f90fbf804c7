#include "core/protocol/wire_frame.h"

namespace usar::protocol {

Vec3 acrossWire(const Vec3& position_m) {
    return {position_m.x(), -position_m.y(), -position_m.z()};
}

Pose acrossWire(const Pose& pose) {
    return {acrossWire(pose.position_m), normalizedAngle(pose.roll_rad), normalizedAngle(-pose.pitch_rad),
            normalizedAngle(-pose.yaw_rad)};
}

} // namespace usar::protocol
