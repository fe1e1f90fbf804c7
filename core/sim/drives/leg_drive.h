// A drive by servos in named joints: legs, heads, arms.
#pragma once

#include "core/sim/drives/driven_joints.h"

namespace usar::sim {

/// Each joint moves to its commanded angle with no more than its torque and speed and holds it; all start at 0. The
/// drive obeys MULTIDRIVE, DRIVE of one joint with all its orders, and SET of a joint, and reports all angles in STA.
/// The body may sleep while it stands still without new commands.
class LegDrive : public JointDrive {
public:
    /// Fails if one of the drive's joints does not exist.
    static Result<std::unique_ptr<Drive>> make(const RobotModel& model, Physics& physics, BodyId body);

    bool obey(const protocol::Command& command) override;
    void beforeStep(Seconds dt) override;
    bool idle() const override { return still_for_ > Seconds{0.0}; }

    using Drive::addTo;
    void addTo(protocol::RobotState& state) const override;

private:
    LegDrive(const RobotModel& model, Physics& physics, BodyId body, const std::vector<std::size_t>& joints);

    std::vector<std::size_t> reported_; ///< joints in the order in which STA reports them
    Seconds still_for_{0.0};            ///< time without motion or a new command
};

} // namespace usar::sim
