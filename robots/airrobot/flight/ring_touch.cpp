#include "robots/airrobot/flight/ring_touch.h"

namespace usar::airrobot {

namespace {

constexpr double leans = 0.06;
constexpr double tips = 0.18; ///< A robot that leans so far tips over, even while it still climbs as it is told.
/// If the lean of a robot that climbs straight up changes by more than this from one tick to the next, something has
/// met its ring. A robot that climbed on for two more ticks broke (random survey 171056).
constexpr double jolts = 0.05;
constexpr double held_share = 0.6;
constexpr Seconds to_speed{1.0}; ///< So long it takes to climb at all.
constexpr Seconds to_tip{0.35};
constexpr double touch_reach_m = 0.5; ///< from the robot's center to what it has touched
/// A climbing robot is about to touch something, such as the underside of a crown, if a sonar hears it so near.
constexpr double nearly_touches_m = 0.9;
constexpr double touch_height_m = 0.5; ///< So high above the robot's center it is remembered.

} // namespace

Vec2 unusualLean(const Senses& senses, const Vec2& slope) {
    const Vec3 up = senses.base_in_map.rotation() * Vec3::UnitZ();
    return up.head<2>() / up.z() + slope;
}

namespace {

/// The middle of what sonars hear close to the ring; nullopt if none does.
std::optional<Vec2> heardClose_m(const Senses& senses) {
    Vec2 sum_m = Vec2::Zero();
    int count = 0;
    for (const SonarEcho& echo : senses.sonars)
        if (echo.hit && echo.range_m < nearly_touches_m) {
            sum_m += echo.center_in_map_m.head<2>();
            ++count;
        }
    return count == 0 ? std::nullopt : std::optional<Vec2>(sum_m / count);
}

} // namespace

std::optional<Vec3> RingTouch::feel(const Senses& senses, const Vec2& slope, double commanded_m_s) {
    if (commanded_m_s < least_climb_m_s) {
        climbing_since_.reset();
        return std::nullopt;
    }
    const Vec2 lean = unusualLean(senses, slope);
    const Vec2 jolt = climbing_since_ ? Vec2(lean - lean_before_) : Vec2(Vec2::Zero());
    lean_before_ = lean;
    if (!climbing_since_)
        climbing_since_ = senses.now;
    const auto close_m = heardClose_m(senses);
    only_hears_ = close_m.has_value();
    if (close_m) {
        climbing_since_.reset();
        return Vec3(close_m->x(), close_m->y(), senses.position_m().z() + touch_height_m);
    }
    const bool jolted = jolt.norm() > jolts;
    const bool tipping = lean.norm() > tips;
    const bool held = lean.norm() > leans && senses.velocity_in_map_m_s.z() < held_share * commanded_m_s;
    if (senses.now - *climbing_since_ < (tipping ? to_tip : to_speed) + senses.late || !(jolted || tipping || held))
        return std::nullopt;
    climbing_since_.reset();
    const Vec2 met_m = senses.position2_m() + touch_reach_m * (jolted ? jolt : lean).normalized();
    return Vec3(met_m.x(), met_m.y(), senses.position_m().z() + touch_height_m);
}

} // namespace usar::airrobot
