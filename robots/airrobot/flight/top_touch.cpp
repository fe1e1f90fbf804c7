#include "robots/airrobot/flight/top_touch.h"

#include <cmath>
#include <utility>

namespace usar::airrobot {

namespace {

/// A robot that is to become faster by 1 m/s leans so far (its tangent), within 0.07, in eight random surveys.
constexpr double lean_per_m_s = 0.2;
/// In 1,500 ticks of climbs on the way, nothing but a touch made it lean so far all at once; the greatest was 0.15.
constexpr double pressed_lean = 0.17;
/// Slowly and straight up, a robot that climbs slower than it is told and leans so far is held from above: that was so
/// in 2 of 61 healthy surveys.
constexpr double pinned_lean = 0.1;
constexpr double pinned_share = 0.85;
constexpr double on_the_spot_m_s = 0.35;
constexpr double slow_climb_m_s = 0.5;
constexpr double same_climb_m_s = 0.02;
constexpr double least_climb_m_s = 0.25;
constexpr Seconds remembered{1.2};
constexpr std::size_t least_samples = 3;
constexpr double reach_m = 0.5;  ///< from the robot's center to what it has touched
constexpr double height_m = 0.3; ///< So high above the robot's center it is remembered.
constexpr double below_m_s = 0.5;
constexpr double no_leap_m_s = 5.0;
constexpr double aloft_m = 1.5; ///< A lower robot may have lifted off from a slope.
constexpr Seconds explains_within{0.5};
constexpr Seconds sinking{1.0};

/// How the robot leans and would not lean only because it is to become as fast as it was told.
Vec2 unexplained(const Senses& senses, const Vec2& told_m_s) {
    const Vec3 up = senses.base_in_map.rotation() * Vec3::UnitZ();
    const Vec2 faster_m_s = told_m_s - senses.velocity_in_map_m_s.head<2>();
    return up.head<2>() / up.z() - lean_per_m_s * faster_m_s;
}

} // namespace

std::optional<Vec2> TopTouch::surplus(const Senses& senses, const Doing& doing) {
    if (senses.ins_age > Seconds{0.0} || senses.late > Seconds{0.0})
        return std::nullopt;
    if (senses.velocity_in_map_m_s.head<2>().norm() > no_leap_m_s) { // The estimate of its place has leapt.
        last_.clear();
        return std::nullopt;
    }
    while (!last_.empty() && senses.now - last_.front().time > remembered)
        last_.pop_front();
    Vec2 usual = Vec2::Zero();
    for (const Sample& one : last_)
        usual += one.lean / static_cast<double>(last_.size());
    const bool known = last_.size() >= least_samples;
    last_.push_back({senses.now, doing.velocity_in_map_m_s, unexplained(senses, doing.velocity_in_map_m_s)});
    if (!known)
        return std::nullopt;
    Vec2 least = last_.back().lean - usual;
    for (const Sample& one : last_) { // It obeys a moment later, so the command before may explain its lean.
        const Vec2 more = unexplained(senses, one.told_m_s) - usual;
        if (senses.now - one.time <= explains_within && more.norm() < least.norm())
            least = more;
    }
    return least;
}

std::optional<Motion> TopTouch::free(const Senses& senses, const Doing& doing) {
    met_m_.reset();
    const auto more = surplus(senses, doing);
    leans_more_ = more ? more->norm() : 0.0;
    if (sinking_since_ && senses.now - *sinking_since_ > sinking)
        sinking_since_.reset();
    const bool steady = std::abs(doing.climb_m_s - std::exchange(last_climb_m_s_, doing.climb_m_s)) < same_climb_m_s;
    const bool held = steady && doing.climb_m_s <= slow_climb_m_s &&
                      doing.velocity_in_map_m_s.norm() < on_the_spot_m_s &&
                      senses.velocity_in_map_m_s.z() < pinned_share * doing.climb_m_s;
    const bool pressed = leans_more_ > (held ? pinned_lean : pressed_lean);
    const bool climbs = doing.climb_m_s >= least_climb_m_s && senses.heightOverGround_m(1e9) > aloft_m;
    if (!sinking_since_ && climbs && (pressed || senses.leans_beyond_belief)) {
        sinking_since_ = senses.now;
        if (pressed) {
            const Vec2 at_m = senses.position2_m() + reach_m * more->normalized();
            met_m_ = Vec3(at_m.x(), at_m.y(), senses.position_m().z() + height_m);
        }
    }
    if (!sinking_since_)
        return std::nullopt;
    return Motion{.climb_m_s = -below_m_s, .sudden = true};
}

} // namespace usar::airrobot
