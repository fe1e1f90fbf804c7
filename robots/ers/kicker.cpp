#include "robots/ers/kicker.h"

#include <algorithm>
#include <cmath>

#include "core/base/numbers.h"

namespace usar::ers {

namespace {

constexpr Seconds fresh{0.5};
constexpr double least_depth_m = 0.02; ///< least distance in front of the camera; tangents are useless below it
const double edge_of_picture = std::tan(radians(56.9 / 2.0)); ///< of an ERS-7's camera, as a tangent
constexpr double bow_per_rad = 0.4; ///< share by which the head follows the ball downward in each tick
constexpr double rise_rad = 0.03;   ///< how far the head rises in each tick while the ball is not visible
constexpr double tightest = -0.6;   ///< inner stride as a share of the outer one when the ball is far to the side
constexpr double lying_rad = 1.1;
constexpr double way_step_m = 0.1; ///< shorter moves are only swaying and do not count

} // namespace

void Kicker::perceive(const agent::Tick& tick) {
    if (!run_.began)
        lost_at_ = tick.now;
    run_.step(tick.now);
    lookForBall();
    watchBalance(tick.robot.sensors);
    if (const Seconds whole(settings_.play_time_s); run_.isOver(whole))
        run_.ending = {true, "Played for " + fixed(whole.count(), 0) + " s; the ball was at the paws " +
                                 std::to_string(kicks_) + " times."};
}

/// Finds the ball in the newest reading. A near ball that leaves the picture is between the paws, and the robot kicks
/// it by walking on.
void Kicker::lookForBall() {
    const auto& newest = ball_.newest();
    const bool visible = newest && run_.now - newest->time < fresh && newest->value.visible.value_or(false) &&
                         newest->value.position && newest->value.position->x() > least_depth_m;
    if (!visible) {
        if (seen_ && bow_rad_ > settings_.near_rad) {
            kicking_since_ = run_.now;
            ++kicks_;
        }
        if (seen_)
            lost_at_ = run_.now;
        seen_.reset();
        bow_rad_ = std::max(0.0, bow_rad_ - rise_rad);
        return;
    }
    const Vec3& ball = *newest->value.position; // Forward, right, down
    const std::vector<double>& place = newest->value.place_in_picture;
    seen_ = place.size() == 2 && std::isfinite(place[0]) && std::isfinite(place[1])
                ? ImagePlace{place[0] * edge_of_picture, place[1] * edge_of_picture} // as the thesis steers
                : ImagePlace{ball.y() / ball.x(), ball.z() / ball.x()};
    last_on_the_right_ = seen_->right > 0.0;
    bow_rad_ = std::clamp(bow_rad_ + bow_per_rad * std::atan(seen_->down), 0.0, deepest_bow_rad);
    kicking_since_.reset();
}

void Kicker::watchBalance(const modules::SensorModule& sensors) {
    const auto* const ins = sensors.ins();
    if (!ins)
        return;
    base_in_map_ = ins->value.base_in_map;
    const bool lies = std::abs(base_in_map_->roll_rad) > lying_rad || std::abs(base_in_map_->pitch_rad) > lying_rad;
    if (lies && !fallen_)
        events_.emplace_back(Severity::Warning, "The robot has fallen over; it is righted.");
    fallen_ = lies;
    const Vec2 here_m = base_in_map_->position_m.head<2>();
    const double step_m = (here_m - way_from_m_).norm();
    if (run_.now == *run_.began || step_m > way_step_m) {
        way_m_ += run_.now == *run_.began ? 0.0 : step_m;
        way_from_m_ = here_m;
    }
}

std::optional<protocol::MultiDrive> Kicker::walk() {
    const Strides strides = this->strides();
    protocol::MultiDrive drive;
    if (!gait_.next(run_.now, strides, settings_.lift_m, drive))
        return std::nullopt;
    bowHead(drive, bow_rad_);
    return drive;
}

/// Returns strides for a turn; `turn_right` is limited to -1 to 1. The paws on the inner side take shorter steps, or
/// steps backward.
Strides Kicker::steer(double turn_right) const {
    const double inner_m = settings_.stride_m * std::lerp(1.0, tightest, std::min(1.0, std::abs(turn_right)));
    return turn_right > 0.0 ? Strides{settings_.stride_m, inner_m} : Strides{inner_m, settings_.stride_m};
}

Strides Kicker::strides() {
    if (run_.paused || fallen_ || !gait_.standing()) {
        run_.state = run_.paused ? "paused" : fallen_ ? "fallen over" : "standing up";
        return {};
    }
    if (seen_) {
        run_.state = bow_rad_ > settings_.near_rad ? "at the ball" : "walking to the ball";
        return steer(settings_.steering * seen_->right);
    }
    if (kicking_since_ && run_.now - *kicking_since_ < Seconds(settings_.kick_s)) {
        run_.state = "kicking";
        return {settings_.stride_m, settings_.stride_m};
    }
    return circle();
}

/// Walks in circles toward the side where the ball was last seen. Tight and wide circles alternate, because with a
/// single size the robot could walk around the ball forever.
Strides Kicker::circle() {
    const Seconds lasts = run_.now - lost_at_;
    const bool tight = static_cast<long long>(lasts / Seconds(settings_.circle_s)) % 2 == 0;
    run_.state = tight ? "looking around for the ball" : "looking for the ball";
    const double inner_m = settings_.stride_m * (tight ? settings_.tight_share_pct : settings_.wide_share_pct) / 100.0;
    return last_on_the_right_ ? Strides{settings_.stride_m, inner_m} : Strides{inner_m, settings_.stride_m};
}

} // namespace usar::ers
