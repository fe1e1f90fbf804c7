#include "robots/submarine/level_rule.h"

#include <algorithm>
#include <cmath>

namespace usar::submarine {

namespace {

constexpr double least_speed_m_s = 0.4;
constexpr double climb_share = 0.6;    ///< climb as a share of the pitch; the planes push the hull the other way
constexpr double climb_per_m_hz = 0.2; ///< wanted rate of climb per meter of height error

} // namespace

Level levelOf(const Echoes& echoes, const Settings& settings) {
    if (!echoes.present_m || *echoes.present_m > settings.height_m + settings.level_band_m)
        return Level::Descend;
    return *echoes.present_m < settings.height_m - settings.level_band_m ? Level::Ascend : Level::Keep;
}

double plumbPlane_rad(const Echoes& echoes, const Settings& settings, double plane_rad, double plane_limit_rad) {
    const Level level = levelOf(echoes, settings);
    if (level == Level::Keep)
        return 0.0;
    const double wanted_sign = level == Level::Ascend ? 1.0 : -1.0;
    return wanted_sign * echoes.climb_m_s() > 0.0 ? plane_rad : wanted_sign * plane_limit_rad;
}

Echoes plumb(Echoes echoes, double last_pitch_rad, double pitch_rad) {
    if (echoes.last_m)
        *echoes.last_m *= std::cos(last_pitch_rad);
    if (echoes.present_m)
        *echoes.present_m *= std::cos(pitch_rad);
    return echoes;
}

double wantedPitch_rad(const Echoes& heights, double bottom_rise_m_s, double speed_m_s, const Settings& settings) {
    if (!heights.present_m)
        return -settings.steepest_dive_rad;
    const double wanted_m_s = climb_per_m_hz * (settings.height_m - *heights.present_m) + bottom_rise_m_s;
    const double slope = wanted_m_s / (climb_share * std::max(least_speed_m_s, speed_m_s));
    return std::clamp(std::asin(std::clamp(slope, -1.0, 1.0)), -settings.steepest_dive_rad,
                      settings.steepest_climb_rad);
}

bool tooNear(const Echoes& heights, double bottom_rise_m_s, Seconds foresight, const Settings& settings) {
    return heights.present_m &&
           *heights.present_m - std::max(0.0, bottom_rise_m_s) * foresight.count() < settings.least_height_m;
}

} // namespace usar::submarine
