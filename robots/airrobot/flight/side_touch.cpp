#include "robots/airrobot/flight/side_touch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace usar::airrobot {

namespace {

constexpr Seconds answers_within{1.0}; ///< A turn follows its command in this time.
/// In 16 random surveys, nothing but touches turned it so fast for so long.
constexpr double least_turn_rad_s = 0.07;
constexpr Seconds long_turn{0.15};
constexpr double held_from_m_s = 0.25;
constexpr double sure_aloft_m = 0.8;
/// The INS has no noise where nothing moves, and in wind something always does. A beam below a roof held a robot for a
/// minute, which took that for wind, and shot into a wall as it got free (`tst_random_surveys_campaign`, number
/// 163333).
constexpr double still_within_m = 0.04;
constexpr double sure_to_move_m_s = 0.6; ///< A robot that creeps may be told to do so for seconds.
constexpr Seconds held_fast_after{2.4};
constexpr Seconds longest_pause{0.6};   ///< Meanwhile, it may have been told to stand.
constexpr Seconds obeys_within{0.3};    ///< The robot flies as it was told so long ago.
constexpr double ring_m = 0.5;          ///< from the robot's center to what holds it
constexpr double reaches_above_m = 0.3; ///< It is remembered as high as this above the robot.
constexpr double slides_m_s = 0.08;
constexpr double against_told = -0.3; ///< It cannot press against what lies so far behind it.
constexpr double at_ring_m = 0.6;
constexpr double touches_m = 0.2; ///< A sonar that hears something so near hears what touches the ring or is about to.
constexpr double same_thing_m = 0.15; ///< Sonars that hear ranges as equal as this hear one thing.
constexpr double free_speed_m_s = 0.5;
constexpr double sinks_m_s = 0.4;
constexpr double least_height_m = 1.5; ///< A lower robot does not sink.
constexpr Seconds freeing{1.0};

/// The direction of what holds a robot that is told to fly along `told`, moves like this, and turns to the left
/// (`sign` 1) or to the right (-1). It slides along that, whose friction turns it, so that lies to the left of how it
/// moves if it turns to the left; and it presses against that.
Vec2 towardTouch(const Vec2& told, const Vec2& moves_m_s, double sign) {
    const Vec2 along = moves_m_s.norm() > slides_m_s ? moves_m_s.normalized() : told;
    const Vec2 beside(-sign * along.y(), sign * along.x());
    const Vec2 toward = told + beside;
    return told.dot(beside) < against_told || toward.isZero() ? told : Vec2(toward.normalized());
}

} // namespace

std::optional<Vec2> towardHeard(const Senses& senses, double within_m) {
    double nearest_m = within_m;
    for (const SonarEcho& echo : senses.sonars)
        nearest_m = echo.hit ? std::min(nearest_m, echo.range_m) : nearest_m;
    Vec2 sum = Vec2::Zero();
    for (const SonarEcho& echo : senses.sonars)
        if (echo.hit && echo.range_m < std::min(within_m, nearest_m + same_thing_m))
            sum += (echo.center_in_map_m.head<2>() - senses.position2_m()).normalized();
    return sum.isZero() ? std::nullopt : std::optional<Vec2>(sum.normalized());
}

double SideTouch::unexplained_rad_s(const Senses& senses) const {
    double least_rad_s = 0.0;
    double most_rad_s = 0.0;
    for (const Told& told : told_) {
        least_rad_s = std::min(least_rad_s, told.doing.yaw_rate_rad_s);
        most_rad_s = std::max(most_rad_s, told.doing.yaw_rate_rad_s);
    }
    const double turn_rad_s = senses.ins_yaw_rate_rad_s;
    return std::max(0.0, turn_rad_s - most_rad_s) - std::max(0.0, least_rad_s - turn_rad_s);
}

Vec2 SideTouch::flewBefore_m_s(Seconds turn) const {
    const auto flew = std::ranges::find_if(told_, [&](const Told& told) {
        return told.time > turn - obeys_within && told.doing.velocity_in_map_m_s.norm() >= held_from_m_s;
    });
    return flew == told_.end() ? Vec2::Zero() : flew->doing.velocity_in_map_m_s;
}

std::optional<Vec2> SideTouch::feel(const Senses& senses) {
    if (senses.heightOverGround_m(1e9) < sure_aloft_m || senses.ins_age > Seconds{0.0}) {
        turning_since_.reset();
        return std::nullopt;
    }
    if (const auto toward = towardHeard(senses, touches_m))
        return toward;
    const double turn_rad_s = unexplained_rad_s(senses);
    const double sign = turn_rad_s > 0.0 ? 1.0 : -1.0;
    if (std::abs(turn_rad_s) < least_turn_rad_s) {
        turning_since_.reset();
        return std::nullopt;
    }
    if (!turning_since_ || sign != turns_)
        turning_since_ = senses.now;
    turns_ = sign;
    const Vec2 flew_m_s = flewBefore_m_s(*turning_since_);
    if (senses.now - *turning_since_ < long_turn || flew_m_s.isZero())
        return std::nullopt;
    return towardHeard(senses, at_ring_m)
        .value_or(towardTouch(flew_m_s.normalized(), senses.velocity_in_map_m_s.head<2>(), sign));
}

bool SideTouch::isHeldFast(const Senses& senses, const Vec2& told_m_s) {
    // A pose that repeats itself is not believed after a while, and is the same all the same.
    const bool told = told_m_s.norm() > sure_to_move_m_s && senses.heightOverGround_m(1e9) > sure_aloft_m &&
                      senses.late <= Seconds{0.0};
    const bool pauses = senses.now - std::exchange(asked_at_, senses.now) > longest_pause;
    if (!told || pauses || (senses.position2_m() - still_at_m_).norm() > still_within_m)
        still_since_.reset();
    if (told && !still_since_) {
        still_since_ = senses.now;
        still_at_m_ = senses.position2_m();
    }
    return still_since_ && senses.now - *still_since_ > held_fast_after;
}

std::optional<Motion> SideTouch::free(const Senses& senses, const Doing& doing) {
    met_m_.reset();
    told_.push_back({senses.now, doing});
    while (senses.now - told_.front().time > answers_within + senses.late)
        told_.pop_front();
    if (freeing_since_ && senses.now - *freeing_since_ > freeing)
        freeing_since_.reset();
    holds_fast_ = isHeldFast(senses, doing.velocity_in_map_m_s);
    if (holds_fast_)
        still_since_.reset();
    if (freeing_since_) { // As it turns away from that, other sonars hear it better.
        if (const auto toward = towardHeard(senses, touches_m))
            away_.velocity_in_map_m_s = -free_speed_m_s * *toward;
    } else if (const auto toward = holds_fast_ ? doing.velocity_in_map_m_s.normalized() : feel(senses)) {
        const Vec2 at_m = senses.position2_m() + ring_m * *toward;
        met_m_ = Vec3(at_m.x(), at_m.y(), senses.position_m().z() + reaches_above_m);
        const bool may_sink = !doing.to_ground && !doing.over_things && doing.climb_m_s >= 0.0 &&
                              senses.heightOverGround_m(1e9) > least_height_m;
        away_ = {
            .velocity_in_map_m_s = -free_speed_m_s * *toward, .climb_m_s = may_sink ? -sinks_m_s : 0.0, .sudden = true};
        freeing_since_ = senses.now;
        turning_since_.reset();
    }
    return freeing_since_ ? std::optional(away_) : std::nullopt;
}

} // namespace usar::airrobot
