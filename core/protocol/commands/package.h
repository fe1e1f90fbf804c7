// Commands for mission packages: arms, and cameras that pan and tilt. Values have the server's sign.
#pragma once

#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/protocol/commands/checked_text.h"
#include "core/protocol/commands/description.h"

namespace usar::protocol {

/// The quantity that a value sets: rad, rad/s or N m (m, m/s and N for a sliding joint).
/// MISPKG has no relative orders, unlike DRIVE (see JointOrder).
enum class LinkOrder { Angle, Speed, Torque };
template <>
inline constexpr std::array wire_words<LinkOrder> = {WireWord{"0", LinkOrder::Angle}, WireWord{"1", LinkOrder::Speed},
                                                     WireWord{"2", LinkOrder::Torque}};

/// Both spellings are read; MISPKG is the one that is written.
inline constexpr CommandWord package_word{.word = "MISPKG",
                                          .help = "moves a mission package, such as a camera's pan and tilt",
                                          .example = "MISPKG {Name CameraPanTilt} {Link 1} {Value 0.5} {Link 2} "
                                                     "{Value 0}",
                                          .other_word = "MISSPKG"};
/// The keys below are shared by several commands of this file.
inline constexpr Key package_name{"Name", "the mission package"};
inline constexpr Key package_order{"Order", "0 angle, 1 speed, 2 torque"};
inline constexpr Key link_key{"Link", "a link of it, from 1"};
inline constexpr Key gripper_key{"Gripper", "1 closes it, 0 opens it (UDK)"};

/// The value that one joint is to take.
struct LinkTarget {
    int link = 1;       ///< from 1
    double value = 0.0; ///< unit according to `order`
    LinkOrder order = LinkOrder::Angle;
    bool operator==(const LinkTarget&) const = default;

    static void segments(auto& io, auto& target) {
        io.number(link_key, target.link);
        io.number({"Value", "rad, m, rad/s or N m by Order"}, target.value);
        io.choice(package_order, target.order);
    }
};

/// MISPKG, for both dialects. Each link is written as Link, Value, Order, because UDK accepts no other order.
/// On the wire: `MISPKG {Name Arm} {Link 1} {Value 0.5} {Order 0} {Link 2} {Value 0.25} {Order 1}`.
struct PackageDrive {
    Token package;
    std::vector<LinkTarget> links{};
    std::optional<int> sequence{};        ///< number of a stored sequence of motions; UDK only
    std::optional<bool> gripper_closed{}; ///< UDK only
    bool operator==(const PackageDrive&) const = default;

    static constexpr auto& word = package_word;
    static void segments(auto& io, auto& drive) {
        io.text(package_name, drive.package);
        io.groups(link_key, drive.links);
        io.number({"Seq", "a stored sequence (UDK)"}, drive.sequence);
        io.digit(gripper_key, drive.gripper_closed);
    }
};

/// MISPKG with the pose of the last joint, from which the server computes those of all joints (thesis 3.3). The thesis
/// tells no words for it; ours are those of INIT. Without Rotation only the place counts.
/// On the wire: `MISPKG {Name Arm} {Location 0.75,-0.25,-0.5} {Rotation 0,-0.5,0}`.
struct PackagePose {
    Token package;
    Vec3 tip_in_base_m = Vec3::Zero();    ///< in the robot's frame, which is ours: y left, z up
    std::optional<Vec3> tip_angles_rad{}; ///< roll, pitch and yaw, likewise
    bool operator==(const PackagePose&) const = default;

    static constexpr auto& word = package_word;
    static constexpr auto signs = texts("Location");
    static void segments(auto& io, auto& wanted) {
        io.text(package_name, wanted.package);
        io.position({"Location", "x,y,z in the robot's frame: where the last link's tip shall be"},
                    wanted.tip_in_base_m);
        io.position({"Rotation", "roll,pitch,yaw in the robot's frame"}, wanted.tip_angles_rad);
    }
};

/// The old form of MISPKG, which turns a camera.
/// On the wire: `MISPKG {Name Cam1} {Rotation 0,0.25,0.5} {Order 0}`.
struct PackageRotation {
    Token package;
    double tilt_rad = 0.0; ///< an angle, a speed in rad/s or a torque in N m, according to `order`; so is `pan_rad`
    double pan_rad = 0.0;
    LinkOrder order = LinkOrder::Angle;
    bool operator==(const PackageRotation&) const = default;

    static constexpr auto& word = package_word;
    static constexpr auto signs = texts("Rotation");
    template <class Io>
    static void segments(Io& io, auto& rotation) {
        io.text(package_name, rotation.package);
        Vec3 angles(0.0, rotation.tilt_rad, rotation.pan_rad);
        io.vector({"Rotation", "0,tilt,pan in radians: the old way to turn a camera"}, angles);
        if constexpr (Io::reading) {
            rotation.tilt_rad = angles.y();
            rotation.pan_rad = angles.z();
        }
        io.choice(package_order, rotation.order);
    }
};

/// The angle in rad, or position in m, that one joint of an actuator is to take.
struct LinkValue {
    int link = 1; ///< from 1
    double value = 0.0;
    bool operator==(const LinkValue&) const = default;

    static void segments(auto& io, auto& target) {
        io.number(link_key, target.link);
        io.number({"Value", "rad or m"}, target.value);
    }
};

/// ACT, UDK's newer command for the same purpose.
/// On the wire: `ACT {Name Arm} {Link 1} {Value 0.5} {Link 3} {Value 0}`.
struct ActuatorDrive {
    /// The actuator's name as in its CONF.
    Token actuator;
    std::vector<LinkValue> links{};
    std::optional<bool> gripper_closed{};
    std::optional<int> sequence{}; ///< number of a stored sequence of motions
    bool operator==(const ActuatorDrive&) const = default;

    static constexpr CommandWord word{"ACT", "moves an actuator (UDK)", "ACT {Name KR60Arm} {Link 2} {Value 0.7854}"};
    static void segments(auto& io, auto& drive) {
        io.text({"Name", "the actuator"}, drive.actuator);
        io.groups(link_key, drive.links);
        io.digit(gripper_key, drive.gripper_closed);
        io.number({"Sequence", "a stored sequence"}, drive.sequence);
    }
};

} // namespace usar::protocol
