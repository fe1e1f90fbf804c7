// MISSTA, ASTA and EFF: what is mounted on a robot and moves.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/protocol/schema.h"

namespace usar::protocol {

/// `value` is rad of a revolute joint, m of a prismatic one, positive as the joint's own axis has it. `torque_n_m` is
/// the greatest torque with a minus sign, a constant (UT2004 only; usarsim-protocol 4.3).
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

/// MISSTA (UT2004) or ASTA (UDK): one mission package, a camera's pan and tilt or an arm.
struct PackageState {
    std::optional<Seconds> time{};
    std::string name{};
    std::vector<LinkState> links{};

    static constexpr auto groups() { return protocol::groups("Link", &PackageState::links); }
    bool operator==(const PackageState&) const = default;
};

/// EFF (UDK): a gripper, a tool changer and the tool it holds, or something that is on or off.
struct EffecterState {
    std::optional<Seconds> time{};
    std::string type{};
    std::string name{};
    std::optional<bool> closed{};
    std::optional<bool> on{};
    std::string tool_type{};
    std::string tool{};
    bool operator==(const EffecterState&) const = default;
};

} // namespace usar::protocol
