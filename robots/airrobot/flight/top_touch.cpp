#include "robots/airrobot/flight/top_touch.h"

namespace usar::airrobot {

namespace {

/// A robot that is to become faster by 1 m/s leans so far (its tangent), within 0.07, in eight random surveys.
constexpr double lean_per_m_s = 0.2;
/// In 1,500 ticks of climbs on the way, nothing but a touch made it lean so far all at once; the greatest was 0.15.
constexpr double pressed_lean = 0.17;
constexpr double least_climb_m_s = 0.25;
constexpr Seconds remembered{1.2};
constexpr std::size_t least_samples = 3;
constexpr double reach_m = 0.5;  ///< from the robot's center to what it has touched
constexpr double height_m = 0.3; ///< So high above the robot's center it is remembered.
constexpr double below_m_s = 0.5;
constexpr double sinks_above_m = 1.5; ///< A lower robot only stops.
constexpr Seconds sinking{1.0};

Vec2 unexplained(const Senses& senses, const TopTouch::Doing& doing) {
    const Vec3 up = senses.base_in_map.rotation() * Vec3::UnitZ();
    const Vec2 faster_m_s = doing.velocity_in_map_m_s - senses.velocity_in_map_m_s.head<2>();
    return up.head<2>() / up.z() - lean_per_m_s * faster_m_s;
}

} // namespace

std::optional<Vec2> TopTouch::leansMore(const Senses& senses, const Doing& doing) {
    if (senses.ins_age > Seconds{0.0} || senses.late > Seconds{0.0})
        return std::nullopt;
    while (!usual_.empty() && senses.now - usual_.front().time > remembered)
        usual_.pop_front();
    const Vec2 lean = unexplained(senses, doing);
    Vec2 sum = Vec2::Zero();
    for (const Sample& one : usual_)
        sum += one.lean;
    const std::size_t count = usual_.size();
    usual_.push_back({senses.now, lean});
    return count < least_samples ? std::nullopt : std::optional<Vec2>(lean - sum / static_cast<double>(count));
}

std::optional<Motion> TopTouch::free(const Senses& senses, const Doing& doing) {
    met_m_.reset();
    const auto more = leansMore(senses, doing);
    leans_more_ = more ? more->norm() : 0.0;
    if (sinking_since_ && senses.now - *sinking_since_ > sinking)
        sinking_since_.reset();
    const bool pressed = more && more->norm() > pressed_lean;
    if (!sinking_since_ && doing.climb_m_s >= least_climb_m_s && (pressed || senses.leans_beyond_belief)) {
        sinking_since_ = senses.now;
        if (pressed) {
            const Vec2 at_m = senses.position2_m() + reach_m * more->normalized();
            met_m_ = Vec3(at_m.x(), at_m.y(), senses.position_m().z() + height_m);
        }
    }
    if (!sinking_since_)
        return std::nullopt;
    const bool may_sink = senses.heightOverGround_m(1e9) > sinks_above_m;
    return Motion{.climb_m_s = may_sink ? -below_m_s : 0.0, .sudden = true};
}

} // namespace usar::airrobot
