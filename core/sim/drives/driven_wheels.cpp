#include "core/sim/drives/driven_wheels.h"

#include <algorithm>
#include <cmath>

namespace usar::sim {

namespace {

constexpr double standing_rad_s = 0.1;

} // namespace

DrivenWheels::DrivenWheels(DrivenJoints& joints, const std::vector<std::size_t>& wheels, double acceleration_rad_s2)
    : joints_(joints)
    , acceleration_rad_s2_(acceleration_rad_s2) {
    for (const std::size_t joint : wheels)
        wheels_.push_back({.joint = joint, .sign = joints.axis(joint).y() < 0.0 ? -1.0 : 1.0});
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
    const auto limit = [&](const Wheel& wheel) { return joints_.speedLimit(wheel.joint); };
    return limit(*std::ranges::min_element(wheels_, {}, limit));
}

double DrivenWheels::largestTorque() const {
    return joints_.torqueLimit(wheels_.front().joint);
}

} // namespace usar::sim
