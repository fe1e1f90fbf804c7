// Parts of info lines that UT2004 and UDK write in the same way.
#pragma once

#include <cmath>
#include <string_view>

#include "core/protocol/info/answers.h"
#include "core/protocol/info/robot_state.h"
#include "core/protocol/line_writer.h"
#include "core/protocol/sensors/range_scan.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

/// Steering angles and joints of a STA.
/// Absent angles are left out; a joint's name is its key.
inline void writeJoints(LineWriter& line, const RobotState& state) {
    if (state.front_steer_rad)
        line.segment("FrontSteer", acrossWire(*state.front_steer_rad), Decimals::FourCut);
    if (state.rear_steer_rad)
        line.segment("RearSteer", acrossWire(*state.rear_steer_rad), Decimals::FourCut);
    for (const JointAngle& joint : state.joints)
        line.segment(joint.name, joint.angle_rad, Decimals::FourCut);
}

/// The battery of a STA in whole seconds, rounded down.
/// Nothing is written if the state has no battery.
inline void writeBattery(LineWriter& line, const RobotState& state) {
    if (state.battery_left)
        line.whole("Battery", static_cast<long long>(std::floor(state.battery_left->count())));
}

/// One setting of a CONF, with its number if it has no text.
inline void writeSetting(LineWriter& line, std::string_view key, const Setting& setting) {
    if (setting.value.empty() && setting.number)
        line.segment(key, *setting.number, Decimals::FourCut);
    else
        line.segment(key, setting.value);
}

/// Everything of a scan after Time and Type.
/// The dialects differ in the decimals of the ranges.
inline void writeScan(LineWriter& line, const RangeScan& scan, Decimals decimals_of_ranges) {
    line.segment("Name", scan.name);
    line.segment("Resolution", scan.resolution_rad, Decimals::FourCut);
    line.segment("FOV", scan.fov_rad, Decimals::FourCut);
    line.open("Range");
    line.numbers(scan.ranges_m, decimals_of_ranges);
    line.close();
}

} // namespace usar::protocol
