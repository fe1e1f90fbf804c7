#include "core/mission/hand/walking_gait.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>
#include <string_view>

#include "core/agent/leg_kinematics.h"
#include "core/base/text.h"

namespace usar::mission {

namespace {

// Meters, in the plane of a leg, from its hip.
constexpr double upright_m = 0.143; ///< height of the hips above the ground after the spawn
constexpr double walking_m = 0.11;
constexpr double feet_forward_m = 0.015; ///< because the head weighs on the front legs
constexpr double longest_step_m = 0.05;
constexpr double lift_m = 0.01;
constexpr double spread_rad = 0.1;
constexpr double bend_steps = 5.0; ///< all at once it would fall on its nose
constexpr double turning = 0.7;    ///< share of a step that a full turn takes from one side

constexpr std::array<std::size_t, 4> legs{0, 3, 1, 2}; ///< of agent::ers_leg_joints; the first two move together

} // namespace

bool WalkingGait::fits(std::span<const protocol::JointAngle> joints) {
    return std::ranges::all_of(std::views::join(agent::ers_leg_joints), [&](std::string_view name) {
        return std::ranges::any_of(joints, [&](const auto& joint) { return sameWord(joint.name, name); });
    });
}

void WalkingGait::place(protocol::MultiDrive& drive, std::size_t leg, double x_m, double z_m) const {
    const agent::LegAngles angles = agent::legAngles(agent::ers_leg, x_m, -z_m);
    const std::array<double, 3> angles_rad{angles.hip_rad, spread_rad, angles.knee_rad};
    for (std::size_t i = 0; i < angles_rad.size(); ++i)
        drive.joints.push_back({*protocol::Token::make(agent::ers_leg_joints[leg][i]), angles_rad[i]});
}

protocol::MultiDrive WalkingGait::stand() const {
    protocol::MultiDrive drive;
    for (const std::size_t leg : legs)
        place(drive, leg, feet_forward_m * bent_, -upright_m + (upright_m - walking_m) * bent_);
    return drive;
}

std::optional<protocol::MultiDrive> WalkingGait::step(const Stick& stick, double speed_share, Seconds now) {
    constexpr Seconds rounding{0.005}; // Times on the wire have two decimals.
    if (last_ && now >= *last_ && now - *last_ < step_time - rounding)
        return std::nullopt;
    last_ = now;
    if (bent_ < 1.0) {
        bent_ = std::min(1.0, bent_ + 1.0 / bend_steps);
        return stand();
    }
    const double forward = stick.forward * (1.0 - turning * std::abs(stick.turn));
    protocol::MultiDrive drive;
    for (std::size_t i = 0; i < legs.size(); ++i) {
        const int phase = (beat_ + (i < 2 ? 0 : 2)) % 4;
        const double side = agent::ers_leg_joints[legs[i]].front().front() == 'L' ? -1.0 : 1.0;
        const double step_m =
            longest_step_m * speed_share * std::clamp(forward + side * turning * stick.turn, -1.0, 1.0);
        const double swing_m[] = {0.0, step_m / 2.0, 0.0, -step_m / 2.0}; // Lifted, ahead, under, behind.
        place(drive, legs[i], feet_forward_m + swing_m[phase], -walking_m + (phase == 0 ? lift_m : 0.0));
    }
    ++beat_;
    return drive;
}

} // namespace usar::mission
