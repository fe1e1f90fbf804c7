#include "core/sim/drives/wheeled_drive.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"
#include "core/sim/robots/drive.h"

namespace usar::sim {

namespace {

constexpr double standing_rad_s = 0.1;

/// Contacts that press from below, at most 45 degrees off the vertical, are with what the robot stands on.
constexpr double standing_normal_z = 0.7;

std::optional<double> figure(const Numbers& figures, std::string_view key) {
    const auto found = figures.find(key);
    return found == figures.end() ? std::nullopt : std::optional(found->second);
}

} // namespace

DrivenWheels::DrivenWheels(DrivenJoints& joints, const std::vector<std::size_t>& wheels, double acceleration_rad_s2)
    : joints_(joints)
    , acceleration_rad_s2_(acceleration_rad_s2) {
    for (const std::size_t joint : wheels)
        wheels_.push_back({.joint = joint, .sign = joints[joint].axis_in_base.y() < 0.0 ? -1.0 : 1.0});
}

void DrivenWheels::want(std::size_t wheel, double spin_rad_s) {
    wheels_[wheel].wanted_rad_s = spin_rad_s;
    wheels_[wheel].held = wheels_[wheel].held && spin_rad_s == 0.0;
}

void DrivenWheels::leave(std::size_t joint) {
    for (Wheel& wheel : wheels_)
        if (wheel.joint == joint)
            wheel.ours = false;
}

void DrivenWheels::takeBack() {
    for (Wheel& wheel : wheels_) {
        if (!wheel.ours) {
            wheel.now_rad_s = wheel.sign * joints_.state(wheel.joint).velocity;
            wheel.told = false;
            wheel.held = false;
        }
        wheel.ours = true;
    }
}

void DrivenWheels::step(Seconds dt) {
    const double most_rad_s = acceleration_rad_s2_ * dt.count();
    for (Wheel& wheel : wheels_) {
        const double missing_rad_s = wheel.wanted_rad_s - wheel.now_rad_s;
        if (!wheel.ours || wheel.held)
            continue;
        if (wheel.told && missing_rad_s == 0.0) {
            brake(wheel);
            continue;
        }
        wheel.now_rad_s = acceleration_rad_s2_ > 0.0 && std::abs(missing_rad_s) > most_rad_s
                              ? wheel.now_rad_s + std::copysign(most_rad_s, missing_rad_s)
                              : wheel.wanted_rad_s;
        joints_.spin(wheel.joint, wheel.sign * wheel.now_rad_s);
        wheel.told = true;
    }
}

void DrivenWheels::brake(Wheel& wheel) {
    const JointState now = joints_.state(wheel.joint);
    if (wheel.now_rad_s != 0.0 || std::abs(now.velocity) > standing_rad_s)
        return;
    joints_.hold(wheel.joint, now.position);
    wheel.held = true;
}

bool DrivenWheels::braking() const {
    return std::ranges::all_of(wheels_, [](const Wheel& wheel) {
        return wheel.ours && wheel.told && wheel.wanted_rad_s == 0.0 && wheel.now_rad_s == 0.0;
    });
}

double DrivenWheels::largestSpin() const {
    const auto limit = [&](const Wheel& wheel) { return joints_[wheel.joint].speed_limit; };
    return limit(*std::ranges::min_element(wheels_, {}, limit));
}

double DrivenWheels::largestTorque() const {
    return joints_[wheels_.front().joint].torque_limit;
}

WheeledDrive::WheeledDrive(const RobotModel& model, Physics& physics, BodyId body,
                           const std::vector<std::size_t>& wheels)
    : JointDrive(model, physics, body)
    , wheels_(joints_, wheels, numberOr(model.drive.numbers, "acceleration", 0.0))
    , figures_(model.drive.numbers) {}

bool WheeledDrive::obeyJoint(const protocol::Command& command) {
    if (off())
        return false;
    const std::vector<std::size_t> obeying = joints_.obey(command);
    for (const std::size_t joint : obeying)
        wheels_.leave(joint);
    others_moving_ |= !obeying.empty();
    return !obeying.empty();
}

void WheeledDrive::beforeStep(Seconds dt) {
    if (off())
        return;
    wheels_.step(dt);
    others_moving_ = others_moving_ && !joints_.still();
    letSleep(idle());
}

void WheeledDrive::afterStep(Seconds dt) {
    collisions_.pass(dt);
    for (const Contact& contact : physics().contacts(body()))
        if (contact.surface != Surface::Ground && contact.normal_in_map.z() < standing_normal_z)
            collisions_.touch();
}

void WheeledDrive::addState(protocol::RobotState& state) const {
    state.front_steer_rad = state.rear_steer_rad = 0.0;
}

void WheeledDrive::addGeometry(protocol::GeometryInfo& geometry) const {
    geometry.wheel_radius_m = figure(figures_, "wheel_radius");
    geometry.wheel_separation_m = figure(figures_, "wheel_separation");
    geometry.wheel_base_m = figure(figures_, "wheel_base");
}

void WheeledDrive::addSettings(std::vector<protocol::Setting>& settings) const {
    settings.push_back({"MaxSpeed", "", wheels_.largestSpin()});
    settings.push_back({"MaxTorque", "", wheels_.largestTorque()});
    settings.push_back({"MaxFrontSteer", "", largest_front_rad_});
    settings.push_back({"MaxRearSteer", "", largest_rear_rad_});
}

Result<std::unique_ptr<Drive>> SkidDrive::make(const RobotModel& model, Physics& physics, BodyId body,
                                               const std::vector<std::size_t>& wheels) {
    if (wheels.empty() || wheels.size() % 2 != 0)
        return failure("a skid drive has " + std::to_string(wheels.size()) + " joints", "robot " + model.class_name,
                       "Name the left wheels' joints and then as many right ones");
    auto drive = std::make_unique<SkidDrive>(model, physics, body, wheels);
    drive->joints_.holdFree();
    return drive;
}

bool SkidDrive::obey(const protocol::Command& command) {
    const auto* drive = std::get_if<protocol::SkidDrive>(&command);
    if (!drive)
        return obeyJoint(command);
    wheels_.takeBack();
    const std::size_t half = wheels_.count() / 2;
    for (std::size_t i = 0; i < wheels_.count(); ++i)
        if (const std::optional<double>& side = i < half ? drive->left_rad_s : drive->right_rad_s)
            wheels_.want(i, limited(*side, wheels_.largestSpin(), drive->normalized));
    return true;
}

void SkidDrive::addState(protocol::RobotState& state) const {
    WheeledDrive::addState(state);
    state.joints = joints_.angles();
}

} // namespace usar::sim
