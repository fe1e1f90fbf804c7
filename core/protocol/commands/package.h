// Mission packages: arms, and cameras that pan and tilt. Values have the server's sign.
#pragma once

#include <optional>
#include <vector>

#include "core/protocol/commands/checked_text.h"

namespace usar::protocol {

/// rad (m for a slider), rad/s, N m.
enum class LinkOrder { Angle, Speed, Torque };

struct LinkTarget {
    int link = 1; ///< from 1
    double value = 0.0;
    LinkOrder order = LinkOrder::Angle;
    bool operator==(const LinkTarget&) const = default;
};

/// MISPKG: both dialects. Each link is written as Link, Value, Order in this order, or UDK would not take it.
struct PackageDrive {
    Token package;
    std::vector<LinkTarget> links{};
    std::optional<int> sequence{};        ///< UDK
    std::optional<bool> gripper_closed{}; ///< UDK
    bool operator==(const PackageDrive&) const = default;
};

/// The old form of MISPKG for a camera.
struct PackageRotation {
    Token package;
    double tilt_rad = 0.0;
    double pan_rad = 0.0;
    LinkOrder order = LinkOrder::Angle;
    bool operator==(const PackageRotation&) const = default;
};

struct LinkValue {
    int link = 1; ///< from 1
    double value = 0.0;
    bool operator==(const LinkValue&) const = default;
};

/// ACT: UDK's newer word.
struct ActuatorDrive {
    Token actuator;
    std::vector<LinkValue> links{};
    std::optional<bool> gripper_closed{};
    std::optional<int> sequence{};
    bool operator==(const ActuatorDrive&) const = default;
};

} // namespace usar::protocol
