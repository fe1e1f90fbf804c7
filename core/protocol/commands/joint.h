// Commands to single joints: flippers, legs, wheels by name. Values have the server's sign.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/protocol/commands/checked_text.h"
#include "core/protocol/commands/drive.h"

namespace usar::protocol {

/// What a value means, in rad (m for a slider), rad/s (m/s) or N m (N). Relative ones are added to what is now.
enum class JointOrder { Angle, Speed, Torque, Brake, RelativeAngle, RelativeSpeed, RelativeTorque };

/// DRIVE of one joint. UT2004 compares its name exactly.
struct JointDrive {
    Token joint;
    JointOrder order = JointOrder::Angle;
    std::optional<double> value{};
    std::optional<double> steer_rad{}; ///< of a wheel that can be steered; counter-clockwise positive
    bool normalized = false;
    DriveSwitches switches{};
    bool operator==(const JointDrive&) const = default;

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

/// MULTIDRIVE: several joints at once; UT2004 only.
struct JointAngleTarget {
    Token joint;
    double angle_rad = 0.0;
    bool operator==(const JointAngleTarget&) const = default;
};
struct MultiDrive {
    std::vector<JointAngleTarget> joints{};
    bool operator==(const MultiDrive&) const = default;
};

/// SET of a joint. UDK knows angle and stiffness only, and the names AllAngles and AllJoints.
enum class JointOpcode { Angle, Speed, Torque, RelativeAngle, RelativeSpeed, RelativeTorque, Stiffness };
struct SetJoint {
    Token joint;
    JointOpcode opcode = JointOpcode::Angle;
    double value = 0.0;                ///< rad, rad/s, N m, or 0..1 of stiffness
    std::optional<double> steer_rad{}; ///< counter-clockwise positive
    bool operator==(const SetJoint&) const = default;
};

} // namespace usar::protocol
