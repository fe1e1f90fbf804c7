#include "robots/airrobot/flight/landing.h"

#include <cmath>
#include <limits>

namespace usar::airrobot {

namespace {

constexpr double body_radius_m = 1.2;
constexpr double even_m = 0.5;
constexpr double ring_step_m = 1.0;
constexpr int spots = 12;
constexpr double still_m_s = 0.06;
/// Slightly less than a second, because printed times are rounded.
constexpr Seconds still_needed{0.95};
constexpr double near_ground_m = 1.5;

double unevenness_m(const ObstacleMemory& memory, const Vec2& place_m) {
    const auto high_m = memory.highest_m(place_m, body_radius_m);
    const auto low_m = memory.lowest_m(place_m, body_radius_m);
    return high_m && low_m ? *high_m - *low_m : std::numeric_limits<double>::infinity();
}

} // namespace

Vec2 landingPlace_m(const ObstacleMemory& memory, const Vec2& wanted_m, double radius_m) {
    Vec2 best_m = wanted_m;
    double best_unevenness_m = unevenness_m(memory, wanted_m);
    for (double ring_m = ring_step_m; ring_m <= radius_m && best_unevenness_m > even_m; ring_m += ring_step_m) {
        for (int i = 0; i < spots; ++i) {
            const double bearing_rad = 2.0 * pi * i / spots;
            const Vec2 place_m = wanted_m + ring_m * Vec2(std::cos(bearing_rad), std::sin(bearing_rad));
            const double here_m = unevenness_m(memory, place_m);
            if (here_m < best_unevenness_m) {
                best_m = place_m;
                best_unevenness_m = here_m;
            }
        }
    }
    return best_m;
}

double Touchdown::sinkRate_m_s(const Senses& senses, const Settings& settings) const {
    const bool near_ground = senses.heightOverGround_m(0.0) < settings.landing_slow_below_m;
    return near_ground ? settings.landing_speed_m_s : settings.descent_speed_m_s;
}

bool Touchdown::touched(const Senses& senses) {
    const bool still = std::abs(senses.velocity_in_map_m_s.z()) < still_m_s;
    if (!still || senses.heightOverGround_m(0.0) >= near_ground_m)
        still_since_.reset();
    else if (!still_since_)
        still_since_ = senses.now;
    return still_since_ && senses.now - *still_since_ >= still_needed;
}

} // namespace usar::airrobot
