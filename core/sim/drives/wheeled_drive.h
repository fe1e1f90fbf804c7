// Common base of the drives on wheels, however they steer. Part of the drives.
#pragma once

#include "core/base/result.h"
#include "core/sim/drives/driven_wheels.h"
#include "core/sim/robots/collision_counter.h"

namespace usar::sim {

/// Settings of the model's drive: `wheel_radius`, `wheel_separation` and `wheel_base` (m) for GEO, and `acceleration`
/// of a wheel's spin (rad/s2; unlimited if absent). Torque and speed of a wheel are limited by its joint. Other joints,
/// such as flippers, obey commands to single joints. The robot may sleep while its wheels brake. Touching a plant, a
/// building or another body counts as a collision unless the robot stands on it.
class WheeledDrive : public JointDrive {
public:
    void beforeStep(Seconds dt) override;
    void afterStep(Seconds dt) override;
    int collisions() const override { return collisions_.count(); }
    bool idle() const override { return off() || (wheels_.braking() && !others_moving_); }

    using Drive::addTo;
    void addTo(protocol::RobotState& state) const override;
    void addTo(protocol::GeometryInfo& geometry) const override;
    void addTo(std::vector<protocol::Setting>& settings) const override;

protected:
    /// `wheels` are the driven joints. `model` is not kept; `physics` must outlive the drive.
    WheeledDrive(const RobotModel& model, Physics& physics, BodyId body, const std::vector<std::size_t>& wheels);

    /// Obeys a command to single joints. Returns true if at least one of them is here.
    bool obeyJoint(const protocol::Command& command);

    DrivenWheels wheels_;
    double largest_front_rad_ = 0.0; ///< largest steering angles; 0 for skid-steered robots
    double largest_rear_rad_ = 0.0;

private:
    Numbers figures_;
    CollisionCounter collisions_;
    bool others_moving_ = false; ///< a joint with a command of its own has not come to rest
};

/// The links on these joints. An error names the joint that does not exist.
Result<std::vector<std::size_t>> linksOn(const RobotModel& model, const std::vector<std::string>& joints);

} // namespace usar::sim
