// Parts of info lines that UT2004 and UDK write in the same way.
#pragma once

#include <cmath>
#include <string_view>
#include <vector>

#include "core/protocol/info/answers.h"
#include "core/protocol/info/game_info.h"
#include "core/protocol/info/robot_state.h"
#include "core/protocol/line_writer.h"
#include "core/protocol/sensors/range_scan.h"
#include "core/protocol/wire_frame.h"

namespace usar::protocol {

/// Steering angles of a STA.
/// Absent ones are left out.
inline void writeSteering(LineWriter& line, const RobotState& state) {
    if (state.front_steer_rad)
        line.segment("FrontSteer", acrossWire(*state.front_steer_rad), Decimals::FourCut);
    if (state.rear_steer_rad)
        line.segment("RearSteer", acrossWire(*state.rear_steer_rad), Decimals::FourCut);
}

/// Joints of a STA.
/// A joint's name is its key.
inline void writeJoints(LineWriter& line, const RobotState& state) {
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

/// Named places with their poses in one segment after their number.
/// The dialects differ in the decimals.
inline void writePlaces(LineWriter& line, std::string_view count_key, const std::vector<StartPose>& places,
                        Decimals decimals) {
    line.text("NFO");
    line.whole(count_key, static_cast<long long>(places.size()));
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Pose on_wire = acrossWire(places[i].pose_in_map);
        line.text(i == 0 ? " {" : " ");
        line.text(places[i].name);
        line.text(" ");
        line.numbers(on_wire.position_m, decimals);
        line.text(" ");
        line.numbers(anglesOf(on_wire), decimals);
    }
    if (!places.empty())
        line.close();
}

} // namespace usar::protocol
