// A drive that steers by the difference of its left and right wheels.
#pragma once

#include "core/sim/drives/wheeled_drive.h"

namespace usar::sim {

/// The first half of the model's drive joints are the left wheels, the second half the right ones. Casters are joints
/// of the body that the drive does not name.
class SkidDrive : public WheeledDrive {
public:
    /// Fails unless the drive names an even number of existing joints, at least two.
    static Result<std::unique_ptr<Drive>> make(const RobotModel& model, Physics& physics, BodyId body);

    bool obey(const protocol::Command& command) override;

    using WheeledDrive::addTo;
    void addTo(protocol::RobotState& state) const override;

private:
    SkidDrive(const RobotModel& model, Physics& physics, BodyId body, const std::vector<std::size_t>& wheels)
        : WheeledDrive(model, physics, body, wheels) {}
};

} // namespace usar::sim
