// Commands to individual joints by name: flippers, legs and wheels. Values have the server's sign.
#pragma once

#include <optional>
#include <vector>

#include "core/protocol/commands/checked_text.h"
#include "core/protocol/commands/description.h"
#include "core/protocol/commands/drive.h"
#include "core/protocol/commands/set_word.h"

namespace usar::protocol {

/// The quantity that a value sets: an angle in rad, a speed in rad/s or a torque in N m (m, m/s and N for a sliding
/// joint). Relative values are added to the current ones.
enum class JointOrder { Angle, Speed, Torque, Brake, RelativeAngle, RelativeSpeed, RelativeTorque };
template <>
inline constexpr std::array wire_words<JointOrder> = {
    WireWord{"0", JointOrder::Angle},          WireWord{"1", JointOrder::Speed},
    WireWord{"2", JointOrder::Torque},         WireWord{"3", JointOrder::Brake},
    WireWord{"10", JointOrder::RelativeAngle}, WireWord{"11", JointOrder::RelativeSpeed},
    WireWord{"12", JointOrder::RelativeTorque}};

/// DRIVE for one joint. UT2004 compares the name case-sensitively.
/// On the wire: `DRIVE {Name FrontLeft} {Order 1} {Value 2} {Steer 0.5} {Normalized false}`.
struct JointDrive {
    Token joint;
    JointOrder order = JointOrder::Angle;
    /// An absent value leaves the joint's last one in force.
    std::optional<double> value{};     ///< unit according to `order`
    std::optional<double> steer_rad{}; ///< for a steerable wheel; counterclockwise positive
    bool normalized = false;           ///< `value` is in percent of the maximum; not limited
    DriveSwitches switches{};
    bool operator==(const JointDrive&) const = default;

    static constexpr auto& word = drive_word;
    /// A DRIVE with a Name is one for a joint, whatever else it has.
    static constexpr auto signs = texts("Name");
    static void segments(auto& io, auto& drive) {
        io.text({"Name", "a joint, spelled exactly"}, drive.joint);
        io.choice({"Order", "0 angle, 1 speed, 2 torque, 3 brake; 10, 11, 12 relative"}, drive.order);
        io.beginScale(drive.normalized);
        io.number({"Value", "rad, m, rad/s or N m by Order"}, drive.value);
        io.number({"Steer", "steering angle of the joint's wheel, rad"}, drive.steer_rad, {.turned = true});
        io.endScale();
        DriveSwitches::segments(io, drive.switches);
    }
};

/// The angle that one joint is to take.
struct JointAngleTarget {
    Token joint;
    double angle_rad = 0.0;
    bool operator==(const JointAngleTarget&) const = default;
};
/// MULTIDRIVE: sets several joints at once; UT2004 only.
/// On the wire: `MULTIDRIVE {FRFlipper 0.5} {FLFlipper -0.5}`.
struct MultiDrive {
    std::vector<JointAngleTarget> joints{};
    bool operator==(const MultiDrive&) const = default;

    static constexpr CommandWord word{.word = "MULTIDRIVE",
                                      .help = "sets several joints at once (UT2004)",
                                      .example = "MULTIDRIVE {FRFlipper 0.5} {FLFlipper 0.5}",
                                      .drives = true};
    /// The joints that are offered for completion; any other is understood, too.
    static constexpr std::array usual_joints = {
        Key{"FRFlipper", "front right flipper, rad"}, Key{"FLFlipper", "front left flipper, rad"},
        Key{"RRFlipper", "rear right flipper, rad"}, Key{"RLFlipper", "rear left flipper, rad"},
        Key{"<joint>", "any joint by its name, rad"}};
    static void segments(auto& io, auto& drive) { io.joints(usual_joints, drive.joints); }
};

/// The quantity that a SET of a joint changes. UDK knows only Angle and Stiffness.
enum class JointOpcode { Angle, Speed, Torque, RelativeAngle, RelativeSpeed, RelativeTorque, Stiffness };
/// Servers also accept the numbers and Target; the first word for each quantity is the one that is written.
template <>
inline constexpr std::array wire_words<JointOpcode> = {WireWord{"Angle", JointOpcode::Angle},
                                                       WireWord{"Target", JointOpcode::Angle},
                                                       WireWord{"Velocity", JointOpcode::Speed},
                                                       WireWord{"Torque", JointOpcode::Torque},
                                                       WireWord{"RelAngle", JointOpcode::RelativeAngle},
                                                       WireWord{"RelVelocity", JointOpcode::RelativeSpeed},
                                                       WireWord{"RelTorque", JointOpcode::RelativeTorque},
                                                       WireWord{"Stiffness", JointOpcode::Stiffness},
                                                       WireWord{"0", JointOpcode::Angle},
                                                       WireWord{"1", JointOpcode::Speed},
                                                       WireWord{"2", JointOpcode::Torque},
                                                       WireWord{"10", JointOpcode::RelativeAngle},
                                                       WireWord{"11", JointOpcode::RelativeSpeed},
                                                       WireWord{"12", JointOpcode::RelativeTorque}};

/// SET of a joint. UDK also accepts the names AllAngles and AllJoints.
/// On the wire: `SET {Type Joint} {Name LeftWheel} {Opcode Torque} {Params 5,0.25}`.
struct SetJoint {
    Token joint;
    JointOpcode opcode = JointOpcode::Angle;
    double value = 0.0;                ///< rad, rad/s, N m, or a stiffness of 0..1
    std::optional<double> steer_rad{}; ///< for a steerable wheel; counterclockwise positive
    bool operator==(const SetJoint&) const = default;

    static constexpr auto& word = set_word;
    static void segments(auto& io, auto& set) {
        io.mark(set_type, "Joint");
        io.text(set_name, set.joint);
        io.choice(set_opcode, set.opcode);
        io.valueAndSteer({"Params", "Joint: value, or value,steering angle"}, set.value, set.steer_rad);
    }
};

} // namespace usar::protocol
