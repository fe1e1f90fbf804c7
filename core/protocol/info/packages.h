// MISSTA, ASTA and EFF: the states of moving things that are mounted on a robot.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/schema.h"

namespace usar::protocol {

/// The state of one joint. `value` is in rad for a revolute joint and in m for a prismatic one, positive along the
/// joint's own axis. `torque_n_m` is a constant, the maximum torque with a minus sign (UT2004 only;
/// protocol.md 4.3).
struct LinkState {
    long long link = 0; ///< from 1
    double value = 0.0;
    std::optional<double> torque_n_m{};

    static constexpr auto items() {
        return std::tuple(
            item("Link", &LinkState::link, "link"), item("Value", &LinkState::value, "value"),
            item("Torque", &LinkState::torque_n_m, "torque", "N m", Crossing::None, Decimals::TwoRounded));
    }
    bool operator==(const LinkState&) const = default;
};

/// MISSTA (UT2004) or ASTA (UDK): the state of one mission package, such as an arm or the pan and tilt of a camera.
/// On the wire: `MISSTA {Time 1} {Name Cam} {Link 1} {Value 0.5} {Torque -20.00} {Link 2} {Value 0}`.
struct PackageState {
    std::optional<Seconds> time{};
    std::string name{};
    std::vector<LinkState> links{};

    static constexpr auto groups() { return protocol::groups("Link", &PackageState::links); }
    bool operator==(const PackageState&) const = default;
};

/// EFF (UDK): the state of a gripper, of a tool changer and the tool that it holds, or of something that is on or off.
/// Absent and empty values do not apply to the effecter.
/// On the wire: `EFF {Time 41} {Type ToolChanger} {Name T} {Status CLOSED} {ToolType Gripper} {Tool G1}`.
struct EffecterState {
    std::optional<Seconds> time{};
    std::string type{};
    std::string name{};
    std::optional<bool> closed{}; ///< grippers and tool changers only
    std::optional<bool> on{};     ///< switchable effecters only
    std::string tool_type{};      ///< type of the tool in a tool changer
    std::string tool{};           ///< name of that tool
    bool operator==(const EffecterState&) const = default;
};

} // namespace usar::protocol
