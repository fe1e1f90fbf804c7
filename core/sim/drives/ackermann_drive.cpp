#include "core/sim/drives/ackermann_drive.h"

#include <cmath>

#include "core/sim/robots/drive.h"

namespace usar::sim {

namespace {

constexpr double straight = 1e-6; // Below this difference of tangents, nothing turns.

} // namespace

Result<std::unique_ptr<Drive>> AckermannDrive::make(const RobotModel& model, Physics& physics, BodyId body,
                                                    const std::vector<std::size_t>& joints) {
    const double steered = numberOr(model.drive.numbers, "steered", 2.0);
    if (!(steered >= 1.0 && steered < static_cast<double>(joints.size())))
        return failure("an ackermann drive needs driven joints and steered ones", "robot " + model.class_name,
                       "Name the driven joints, then the steered ones, and say in `steered` how many these are");
    if (!(numberOr(model.drive.numbers, "wheel_base", 0.0) > 0.0))
        return failure("an ackermann drive has no wheel_base", "robot " + model.class_name,
                       "Give the distance of its axles in meters");
    const auto first_steered = joints.end() - static_cast<std::ptrdiff_t>(steered);
    return std::unique_ptr<Drive>(
        new AckermannDrive(model, physics, body, {joints.begin(), first_steered}, {first_steered, joints.end()}));
}

AckermannDrive::AckermannDrive(const RobotModel& model, Physics& physics, BodyId body,
                               const std::vector<std::size_t>& wheels, const std::vector<std::size_t>& steered)
    : WheeledDrive(model, physics, body, wheels) {
    largest_front_rad_ = numberOr(model.drive.numbers, "max_front_steer", 0.0);
    largest_rear_rad_ = numberOr(model.drive.numbers, "max_rear_steer", 0.0);
    const double wheel_base_m = numberOr(model.drive.numbers, "wheel_base", 0.0);
    for (const std::size_t joint : steered) {
        const double x_m = joints_[joint].pivot_in_base_m.x();
        const bool front = x_m > 0.0;
        steered_.push_back({joint, joints_[joint].axis_in_base.z() < 0.0 ? -1.0 : 1.0, front});
        front_x_m_ = front ? x_m : x_m + wheel_base_m;
    }
    rear_x_m_ = front_x_m_ - wheel_base_m;
    steer();
}

bool AckermannDrive::obey(const protocol::Command& command) {
    const auto* drive = std::get_if<protocol::AckermannDrive>(&command);
    if (!drive)
        return obeyJoint(command);
    if (off())
        return true;
    wheels_.takeBack();
    takeTerm(drive->speed_rad_s, wheels_.largestSpin(), drive->normalized, spin_rad_s_);
    takeTerm(drive->front_steer_rad, largest_front_rad_, false, front_rad_);
    takeTerm(drive->rear_steer_rad, largest_rear_rad_, false, rear_rad_);
    steer();
    return true;
}

// With the center of turning at (x, y): tan(front) = (front_x - x) / y and tan(rear) = (rear_x - x) / y.
void AckermannDrive::steer() {
    const double difference = std::tan(front_rad_) - std::tan(rear_rad_);
    const bool turns = std::abs(difference) > straight;
    const double center_y_m = turns ? (front_x_m_ - rear_x_m_) / difference : 0.0;
    const double center_x_m = rear_x_m_ - center_y_m * std::tan(rear_rad_);
    for (const Steered& wheel : steered_) {
        const Vec3& at_m = joints_[wheel.joint].pivot_in_base_m;
        const double angle_rad = turns ? std::atan((at_m.x() - center_x_m) / (center_y_m - at_m.y()))
                                       : (wheel.front ? front_rad_ : rear_rad_);
        joints_.hold(wheel.joint, wheel.sign * angle_rad);
    }
    const double middle_m = std::hypot(rear_x_m_ - center_x_m, center_y_m);
    for (std::size_t i = 0; i < wheels_.count(); ++i) {
        const Vec3& at_m = joints_[wheels_.joint(i)].pivot_in_base_m;
        const double way = turns ? std::hypot(at_m.x() - center_x_m, at_m.y() - center_y_m) / middle_m : 1.0;
        wheels_.want(i, limited(spin_rad_s_ * way, wheels_.largestSpin(), false));
    }
}

void AckermannDrive::addState(protocol::RobotState& state) const {
    state.front_steer_rad = meanSteer_rad(true);
    state.rear_steer_rad = meanSteer_rad(false);
}

double AckermannDrive::meanSteer_rad(bool front) const {
    double sum_rad = 0.0;
    int count = 0;
    for (const Steered& wheel : steered_) {
        if (wheel.front != front)
            continue;
        sum_rad += wheel.sign * joints_.state(wheel.joint).position;
        ++count;
    }
    return count > 0 ? sum_rad / count : 0.0;
}

} // namespace usar::sim
