#include "core/sim/drives/omni_drive.h"

#include <cmath>

#include "core/sim/robots/drive.h"

namespace usar::sim {

Result<std::unique_ptr<Drive>> OmniDrive::make(const RobotModel& model, Physics& physics, BodyId body,
                                               const std::vector<std::size_t>& joints) {
    if (joints.empty() || joints.size() % 2 != 0)
        return failure("an omni drive has " + std::to_string(joints.size()) + " joints", "robot " + model.class_name,
                       "Name the wheels' joints and then, in the same order, those that steer them");
    const auto first_steer = joints.begin() + static_cast<std::ptrdiff_t>(joints.size() / 2);
    return std::unique_ptr<Drive>(
        new OmniDrive(model, physics, body, {joints.begin(), first_steer}, {first_steer, joints.end()}));
}

OmniDrive::OmniDrive(const RobotModel& model, Physics& physics, BodyId body, const std::vector<std::size_t>& wheels,
                     const std::vector<std::size_t>& steers)
    : WheeledDrive(model, physics, body, wheels)
    , steers_(steers) {
    for (std::size_t wheel = 0; wheel < steers_.size(); ++wheel) {
        const double limit_rad = joints_[steers_[wheel]].upper;
        (joints_[steers_[wheel]].pivot_in_base_m.x() > 0.0 ? largest_front_rad_ : largest_rear_rad_) = limit_rad;
        steer(wheel, 0.0);
    }
}

void OmniDrive::steer(std::size_t wheel, double angle_rad) {
    const std::size_t joint = steers_[wheel];
    joints_.hold(joint, joints_[joint].axis_in_base.z() < 0.0 ? -angle_rad : angle_rad);
}

bool OmniDrive::obey(const protocol::Command& command) {
    const auto* const drive = std::get_if<protocol::OmniDrive>(&command);
    if (!drive)
        return obeyJoint(command);
    if (off())
        return true;
    wheels_.takeBack();
    for (const protocol::WheelDrive& wanted : drive->wheels) {
        const auto wheel = static_cast<std::size_t>(wanted.wheel);
        if (wanted.wheel < 0 || wheel >= wheels_.count())
            continue; // Servers ignore a wheel that is not there.
        if (wanted.spin_rad_s)
            wheels_.want(wheel, limited(*wanted.spin_rad_s, wheels_.largestSpin(), drive->normalized));
        if (wanted.steer_rad && std::isfinite(*wanted.steer_rad))
            steer(wheel, *wanted.steer_rad);
    }
    return true;
}

/// The means of the front and of the rear wheels.
void OmniDrive::addState(protocol::RobotState& state) const {
    WheeledDrive::addState(state);
    double sum_rad[2] = {0.0, 0.0};
    int count[2] = {0, 0};
    for (const std::size_t joint : steers_) {
        const int end = joints_[joint].pivot_in_base_m.x() > 0.0 ? 0 : 1;
        const double angle_rad = joints_.state(joint).position;
        sum_rad[end] += joints_[joint].axis_in_base.z() < 0.0 ? -angle_rad : angle_rad;
        ++count[end];
    }
    state.front_steer_rad = count[0] > 0 ? sum_rad[0] / count[0] : 0.0;
    state.rear_steer_rad = count[1] > 0 ? sum_rad[1] / count[1] : 0.0;
}

} // namespace usar::sim
