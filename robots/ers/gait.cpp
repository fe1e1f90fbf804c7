#include "robots/ers/gait.h"

#include <algorithm>
#include <cmath>

#include "core/agent/leg_kinematics.h"

namespace usar::ers {

namespace {

constexpr double spread_rad = 0.1; ///< outward angle of the legs, so that the robot does not tip over
constexpr double deepest_nod_rad = 0.25;

constexpr Seconds between_moves{0.19}; ///< slightly less than a tick, because the times of ticks are rounded
constexpr int moves = 4;
constexpr PawPlace middle = standing_paw; ///< place of the paw halfway through a step

/// Returns the place of a paw that is `move` moves into its step.
PawPlace placeAt(int move, double stride_m, double lift_m) {
    static constexpr std::array forward_shares{0.0, 0.5, 0.0, -0.5}; // Of the stride
    const bool lifted = move % moves == 0 && stride_m != 0.0;
    return {middle.forward_m + forward_shares[static_cast<std::size_t>(move % moves)] * stride_m,
            middle.down_m - (lifted ? lift_m : 0.0)};
}

} // namespace

void putPaw(protocol::MultiDrive& drive, Leg leg, const PawPlace& paw) {
    const agent::LegAngles angles = agent::legAngles(agent::ers_leg, paw.forward_m, paw.down_m);
    const std::array<double, 3> angles_rad{angles.hip_rad, spread_rad, angles.knee_rad};
    for (std::size_t i = 0; i < angles_rad.size(); ++i)
        drive.joints.push_back(
            {*protocol::Token::make(agent::ers_leg_joints[static_cast<std::size_t>(leg)][i]), angles_rad[i]});
}

/// Uses the nod first and the neck only for the rest, because leaning the neck forward shifts the weight.
void bowHead(protocol::MultiDrive& drive, double down_rad) {
    const double nod_rad = std::clamp(down_rad, 0.0, deepest_nod_rad);
    drive.joints.push_back({"HeadNod", -nod_rad});
    drive.joints.push_back({"HeadTilt", nod_rad - std::clamp(down_rad, 0.0, deepest_bow_rad)});
    drive.joints.push_back({"HeadPan", 0.0});
}

bool Gait::next(Seconds now, const Strides& strides, double lift_m, protocol::MultiDrive& drive) {
    if (moved_at_ && now - *moved_at_ < between_moves)
        return false;
    moved_at_ = now;
    risen_ = std::min(risen_ + 1, moves_to_rise);
    const bool walks = risen_ == moves_to_rise && strides != Strides{};
    move_ = walks ? (move_ + 1) % moves : 0;
    const double share = static_cast<double>(risen_) / moves_to_rise;
    for (const Leg leg : all_legs) {
        const double stride_m = isLeft(leg) ? strides.left_m : strides.right_m;
        if (walks)
            putPaw(drive, leg, placeAt(move_ + (onFirstDiagonal(leg) ? 0 : moves / 2), stride_m, lift_m));
        else
            putPaw(drive, leg, {middle.forward_m * share, std::lerp(straight_down.down_m, middle.down_m, share)});
    }
    return true;
}

} // namespace usar::ers
