// A robot's joints by name, and how they obey commands to single joints. Part of the drives.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/protocol/command.h"
#include "core/protocol/info/robot_state.h"
#include "core/sim/physics/physics.h"
#include "core/sim/robots/drive.h"
#include "core/sim/robots/robot_model.h"

namespace usar::sim {

/// Joints are identified by the indices of their links. Each is driven with no more than its torque and speed; one
/// without torque cannot be driven. Names are compared without regard to case, because clients write MULTIDRIVE
/// {FLflipper 1.5}. `physics` must outlive it.
class DrivenJoints {
public:
    /// The limits are in N m or N, rad/s or m/s, and rad or m.
    struct Joint {
        std::string name;
        double torque_limit = 0.0; ///< 0: the joint cannot be driven
        double speed_limit = 0.0;
        double lower = 1.0; ///< above `upper` if there are no limits
        double upper = -1.0;
        bool in_package = false; ///< belongs to a mission package or a gripper
        double stiffness = 1.0;  ///< share of the torque that UDK's SET leaves it
        JointMotor motor{};
        Vec3 pivot_in_base_m = Vec3::Zero(); ///< with all joints at 0, as is the axis
        Vec3 axis_in_base = Vec3::UnitZ();   ///< unit vector
    };

    DrivenJoints(const RobotModel& model, Physics& physics, BodyId body);

    /// Obeys JointDrive, MultiDrive and SetJoint. Returns the joints that now do so; none if it is another command or
    /// the joints do not exist. `normalized` speeds and torques are percentages of the joint's limits.
    std::vector<std::size_t> obey(const protocol::Command& command);

    /// Positions in rad or m, speeds in rad/s or m/s, torques in N m or N; each is clamped to the joint's limits.
    void hold(std::size_t joint, double position);
    void spin(std::size_t joint, double speed);
    void push(std::size_t joint, double torque);
    /// Holds flippers and the like (see `angles`) where they start, at 0, until they get a command.
    void holdFree();
    /// Turns all motors off, except those of mission packages.
    void releaseAll();

    /// Limits, place and last command of a joint.
    const Joint& operator[](std::size_t joint) const { return joints_[joint]; }
    /// Current position and velocity of a joint.
    JointState state(std::size_t joint) const { return physics_.joint(body_, joint); }
    /// True if no joint moves noticeably.
    bool still() const;
    /// Angles of flippers and the like: joints with torque and limits that no mission package moves.
    std::vector<protocol::JointAngle> angles() const;

private:
    /// True for a joint with torque and limits that no mission package moves.
    static bool isFree(const Joint& joint) {
        return joint.torque_limit > 0.0 && joint.lower <= joint.upper && !joint.in_package;
    }
    /// The joint by this name, in any case; nullopt if there is none.
    std::optional<std::size_t> find(std::string_view joint) const;
    void drive(std::size_t joint, const JointMotor& motor);
    bool obey(std::size_t joint, protocol::JointOrder order, double value, bool normalized);
    std::vector<std::size_t> obeySet(const protocol::SetJoint& wanted);
    bool obeySet(std::size_t joint, const protocol::SetJoint& wanted);

    Physics& physics_;
    BodyId body_;
    std::vector<Joint> joints_;
};

/// The links on the joints of the model's drive. An error names the joint that does not exist.
Result<std::vector<std::size_t>> drivenLinks(const RobotModel& model);

/// Base of the drives that move joints. `model` is not kept; `physics` must outlive it.
class JointDrive : public Drive {
public:
    void switchOff() override;

protected:
    JointDrive(const RobotModel& model, Physics& physics, BodyId body)
        : joints_(model, physics, body)
        , physics_(physics)
        , body_(body) {}
    /// True once the drive has been switched off.
    bool off() const { return off_; }
    /// Allows or forbids the body to sleep. Tells the physics only if this is new, because that wakes the body.
    void letSleep(bool allowed);
    const Physics& physics() const { return physics_; }
    BodyId body() const { return body_; }

    DrivenJoints joints_;

private:
    Physics& physics_;
    BodyId body_;
    bool off_ = false;
    bool may_sleep_ = false; ///< as the physics was last told
};

/// Each joint moves to its commanded angle with no more than its torque and speed and holds it; all start at 0. The
/// drive obeys MULTIDRIVE, DRIVE of one joint with all its orders, and SET of a joint, and reports all angles in STA.
/// The body may sleep while it stands still without new commands.
class LegDrive : public JointDrive {
public:
    /// `joints` are those that it drives, in the order in which STA reports them.
    LegDrive(const RobotModel& model, Physics& physics, BodyId body, const std::vector<std::size_t>& joints);

    bool obey(const protocol::Command& command) override;
    void beforeStep(Seconds dt) override;
    bool idle() const override { return still_for_ > Seconds{0.0}; }
    void addState(protocol::RobotState& state) const override;

private:
    std::vector<std::size_t> reported_; ///< joints in the order in which STA reports them
    Seconds still_for_{0.0};            ///< time without motion or a new command
};

} // namespace usar::sim
