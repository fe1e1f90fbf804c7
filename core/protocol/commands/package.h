// Commands for mission packages: arms, and cameras that pan and tilt. Values have the server's sign.
#pragma once

#include <optional>
#include <vector>

#include "core/protocol/commands/checked_text.h"

namespace usar::protocol {

/// The quantity that a value sets: rad, rad/s or N m (m, m/s and N for a sliding joint).
enum class LinkOrder { Angle, Speed, Torque };

/// The value that one joint is to take.
struct LinkTarget {
    int link = 1;       ///< from 1
    double value = 0.0; ///< unit according to `order`
    LinkOrder order = LinkOrder::Angle;
    bool operator==(const LinkTarget&) const = default;
};

/// MISPKG, for both dialects. Each link is written as Link, Value, Order, because UDK accepts no other order.
/// On the wire: `MISPKG {Name Arm} {Link 1} {Value 0.5} {Order 0} {Link 2} {Value 0.25} {Order 1}`.
struct PackageDrive {
    Token package;
    std::vector<LinkTarget> links{};
    std::optional<int> sequence{};        ///< number of a stored sequence of motions; UDK only
    std::optional<bool> gripper_closed{}; ///< UDK only
    bool operator==(const PackageDrive&) const = default;
};

/// The old form of MISPKG, which turns a camera.
/// On the wire: `MISPKG {Name Cam1} {Rotation 0,0.25,0.5} {Order 0}`.
struct PackageRotation {
    Token package;
    double tilt_rad = 0.0; ///< an angle, a speed in rad/s or a torque in N m, according to `order`; so is `pan_rad`
    double pan_rad = 0.0;
    LinkOrder order = LinkOrder::Angle;
    bool operator==(const PackageRotation&) const = default;
};

/// The angle in rad, or position in m, that one joint of an actuator is to take.
struct LinkValue {
    int link = 1; ///< from 1
    double value = 0.0;
    bool operator==(const LinkValue&) const = default;
};

/// ACT, UDK's newer command for the same purpose.
/// On the wire: `ACT {Name Arm} {Link 1} {Value 0.5} {Link 3} {Value 0}`.
struct ActuatorDrive {
    Token actuator;
    std::vector<LinkValue> links{};
    std::optional<bool> gripper_closed{};
    std::optional<int> sequence{}; ///< number of a stored sequence of motions
    bool operator==(const ActuatorDrive&) const = default;
};

} // namespace usar::protocol
