// The drive of a robot whose wheels are driven and steered one by one, such as OmniP2AT.
#pragma once

#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/sim/drives/wheeled_drive.h"

namespace usar::sim {

/// The first half of the model's drive joints are the wheels, in the order of DRIVE's WheelNumber, which begins at 0;
/// the second half are the joints that steer them, in the same order. A wheel that a DRIVE does not name keeps its
/// values.
class OmniDrive : public WheeledDrive {
public:
    /// Fails unless there are as many steering joints as wheels.
    static Result<std::unique_ptr<Drive>> make(const RobotModel& model, Physics& physics, BodyId body,
                                               const std::vector<std::size_t>& joints);

    bool obey(const protocol::Command& command) override;
    void addState(protocol::RobotState& state) const override;

private:
    OmniDrive(const RobotModel& model, Physics& physics, BodyId body, const std::vector<std::size_t>& wheels,
              const std::vector<std::size_t>& steers);
    /// Positive angles turn left, whichever way the joint's axis points.
    void steer(std::size_t wheel, double angle_rad);

    std::vector<std::size_t> steers_; ///< links on the steering joints, by wheel
};

} // namespace usar::sim
