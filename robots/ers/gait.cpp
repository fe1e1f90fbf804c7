#include "robots/ers/gait.h"

#include <algorithm>
#include <cmath>

namespace usar::ers {

namespace {

constexpr Seconds between_moves{0.19}; ///< slightly less than a tick, because the times of ticks are rounded
constexpr int moves = 4;
constexpr PawPlace middle = standing_paw; ///< place of the paw halfway through a step

/// Returns the place of a paw that is `move` moves into its step.
PawPlace placeAt(int move, double stride_m, double lift_m) {
    switch (move % moves) {
    case 0:
        return {middle.forward_m, middle.down_m - (stride_m == 0.0 ? 0.0 : lift_m)};
    case 1:
        return {middle.forward_m + stride_m / 2.0, middle.down_m};
    case 3:
        return {middle.forward_m - stride_m / 2.0, middle.down_m};
    default:
        return middle;
    }
}

} // namespace

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
