// Commands to individual joints by name: flippers, legs and wheels. Values have the server's sign.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/protocol/commands/checked_text.h"
#include "core/protocol/commands/drive.h"

namespace usar::protocol {

/// The quantity that a value sets: an angle in rad, a speed in rad/s or a torque in N m (m, m/s and N for a sliding
/// joint). Relative values are added to the current ones.
enum class JointOrder { Angle, Speed, Torque, Brake, RelativeAngle, RelativeSpeed, RelativeTorque };

/// DRIVE for one joint. UT2004 compares the name case-sensitively.
/// On the wire: `DRIVE {Name FrontLeft} {Order 1} {Value 2} {Steer 0.5} {Normalized false}`.
struct JointDrive {
    Token joint;
    JointOrder order = JointOrder::Angle;
    std::optional<double> value{};     ///< unit according to `order`
    std::optional<double> steer_rad{}; ///< for a steerable wheel; counterclockwise positive
    bool normalized = false;           ///< `value` is in percent of the maximum; not limited
    DriveSwitches switches{};
    bool operator==(const JointDrive&) const = default;

    /// Commands for an angle, a speed and a torque; the units are those of a revolute joint.
    static JointDrive toAngle(Token joint, double angle_rad) {
        return {std::move(joint), JointOrder::Angle, angle_rad};
    }
    static JointDrive atSpeed(Token joint, double speed_rad_s) {
        return {std::move(joint), JointOrder::Speed, speed_rad_s};
    }
    static JointDrive withTorque(Token joint, double torque_n_m) {
        return {std::move(joint), JointOrder::Torque, torque_n_m};
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
};

/// The quantity that a SET of a joint changes. UDK knows only Angle and Stiffness.
enum class JointOpcode { Angle, Speed, Torque, RelativeAngle, RelativeSpeed, RelativeTorque, Stiffness };
/// SET of a joint. UDK also accepts the names AllAngles and AllJoints.
/// On the wire: `SET {Type Joint} {Name LeftWheel} {Opcode Torque} {Params 5,0.25}`.
struct SetJoint {
    Token joint;
    JointOpcode opcode = JointOpcode::Angle;
    double value = 0.0;                ///< rad, rad/s, N m, or a stiffness of 0..1
    std::optional<double> steer_rad{}; ///< for a steerable wheel; counterclockwise positive
    bool operator==(const SetJoint&) const = default;
};

} // namespace usar::protocol
