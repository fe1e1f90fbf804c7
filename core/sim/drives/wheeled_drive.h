// Common base of the drives on wheels, however they steer. Part of the drives.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/sim/drives/driven_joints.h"

namespace usar::sim {

/// Positive spin rolls forward, whichever way a wheel's axis points. A wheel that is told to stand brakes and then
/// holds its angle, because a spin of 0 alone lets a robot creep down a slope. A wheel that got a command of its own is
/// left alone until the whole drive is commanded again.
class DrivenWheels {
public:
    /// The acceleration is unlimited if `acceleration_rad_s2` is 0. `joints` must outlive it.
    DrivenWheels(DrivenJoints& joints, const std::vector<std::size_t>& wheels, double acceleration_rad_s2);

    std::size_t count() const { return wheels_.size(); }
    std::size_t joint(std::size_t wheel) const { return wheels_[wheel].joint; } ///< index of the link on its joint
    /// Sets the spin that the wheel is to reach.
    void want(std::size_t wheel, double spin_rad_s);
    /// Leaves the wheel on this joint, if there is one, to a command of its own.
    void leave(std::size_t joint);
    /// Drives all wheels again, from the speeds that they have now.
    void takeBack();
    /// Gives the motors their setpoints for the next physics step.
    void step(Seconds dt);
    /// True if all wheels are told to stand, and brake.
    bool braking() const;
    /// The smallest of the wheels' speed limits, rad/s.
    double largestSpin() const;
    double largestTorque() const; ///< that of the first wheel, N m

private:
    struct Wheel {
        std::size_t joint = 0;
        double sign = 1.0;
        double wanted_rad_s = 0.0;
        double now_rad_s = 0.0; ///< current setpoint on its way to the wanted spin
        bool ours = true;       ///< false while it has a command of its own
        bool told = false;      ///< has got a setpoint
        bool held = false;      ///< holds its angle
    };

    void brake(Wheel& wheel);

    DrivenJoints& joints_;
    std::vector<Wheel> wheels_;
    double acceleration_rad_s2_;
};

/// Settings of the model's drive: `wheel_radius`, `wheel_separation` and `wheel_base` (m) for GEO, and `acceleration`
/// of a wheel's spin (rad/s2; unlimited if absent). Torque and speed of a wheel are limited by its joint. Other joints,
/// such as flippers, obey commands to single joints. The robot may sleep while its wheels brake. Touching a plant, a
/// building or another body counts as a collision unless the robot stands on it.
class WheeledDrive : public JointDrive {
public:
    /// `wheels` are the driven joints. `model` is not kept; `physics` must outlive the drive.
    WheeledDrive(const RobotModel& model, Physics& physics, BodyId body, const std::vector<std::size_t>& wheels);

    void beforeStep(Seconds dt) override;
    void afterStep(Seconds dt) override;
    bool idle() const override { return off() || (wheels_.braking() && !others_moving_); }

    void addState(protocol::RobotState& state) const override;
    void addGeometry(protocol::GeometryInfo& geometry) const override;
    void addSettings(std::vector<protocol::Setting>& settings) const override;

protected:
    /// Obeys a command to single joints. Returns true if at least one of them is here.
    bool obeyJoint(const protocol::Command& command);

    DrivenWheels wheels_;
    double largest_front_rad_ = 0.0; ///< largest steering angles; 0 for skid-steered robots
    double largest_rear_rad_ = 0.0;

private:
    Numbers figures_;
    bool others_moving_ = false; ///< a joint with a command of its own has not come to rest
};

/// The first half of the model's drive joints are the left wheels, the second half the right ones. Casters are joints
/// of the body that the drive does not name.
class SkidDrive : public WheeledDrive {
public:
    using WheeledDrive::WheeledDrive;
    /// Fails unless there is an even number of wheels, at least two.
    static Result<std::unique_ptr<Drive>> make(const RobotModel& model, Physics& physics, BodyId body,
                                               const std::vector<std::size_t>& wheels);

    bool obey(const protocol::Command& command) override;
    void addState(protocol::RobotState& state) const override;
};

} // namespace usar::sim
