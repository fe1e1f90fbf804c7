#include "robots/airrobot/flight/ring_touch.h"

namespace usar::airrobot {

namespace {

constexpr double leans = 0.06;
constexpr double held_share = 0.6;
constexpr Seconds to_speed{1.0};       ///< So long it takes to climb at all.
constexpr double touch_reach_m = 0.5;  ///< from the robot's center to what it has touched
constexpr double touch_height_m = 0.5; ///< So high above the robot's center it is remembered.

} // namespace

std::optional<Vec3> RingTouch::feel(const Senses& senses, const Vec2& slope, double commanded_m_s) {
    if (commanded_m_s < least_climb_m_s) {
        climbing_since_.reset();
        return std::nullopt;
    }
    if (!climbing_since_)
        climbing_since_ = senses.now;
    if (senses.now - *climbing_since_ < to_speed + senses.late ||
        senses.velocity_in_map_m_s.z() > held_share * commanded_m_s)
        return std::nullopt;
    const Vec3 up = senses.base_in_map.rotation() * Vec3::UnitZ();
    const Vec2 lean = up.head<2>() / up.z() + slope;
    if (lean.norm() < leans)
        return std::nullopt;
    climbing_since_.reset();
    const Vec2 met_m = senses.position2_m() + touch_reach_m * lean.normalized();
    return Vec3(met_m.x(), met_m.y(), senses.position_m().z() + touch_height_m);
}

} // namespace usar::airrobot
