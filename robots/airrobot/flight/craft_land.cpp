#include <algorithm>

#include "robots/airrobot/flight/craft.h"

namespace usar::airrobot {

namespace {

constexpr double hears_from_m = 1.5; ///< Lower than this over the ground, sonars hear nothing else.
constexpr double off_ground_m = 0.8; ///< Lower, its legs may stand on something.
/// The ground of its place is the lowest within this distance. It may be higher than that below the robot.
constexpr double place_radius_m = 1.2;

/// It sinks no lower before it has looked around. It had turned by 3.1 rad as it came too low to look, and landed on
/// the edge of a box (`tst_random_surveys_campaign`, number 160541).
constexpr double looks_above_m = 1.1;
constexpr double close_m = 0.4; ///< from the ring to what it hears
constexpr double away_m_s = 0.4;

} // namespace

Descent Craft::descend(const Vec2& asked_m, bool in_need, agent::CommandPort& port) {
    touchdown.mindBattery(senses, settings);
    const Vec2 place_m = touchdown.placeFor_m(asked_m);
    Motion motion = holding(senses, place_m);
    const double height_m = senses.heightOverGround_m(0.0);
    const double above_m = senses.heightOverGround_m(1e9);
    const Vec2 way_m = place_m - senses.position2_m();
    const bool straight = way_m.norm() < in_column_m;
    // It has come up near its base, and crowns are wider higher up.
    const bool over = touchdown.isOver(senses, place_m);
    const double over_place_m = senses.position_m().z() - memory.lowest_m(place_m, place_radius_m).value_or(-1e9);
    const bool high = std::min(height_m, over_place_m) > settings.landing_slow_below_m;
    const bool keeps_off = above_m > off_ground_m && !touchdown.sinksAnyway();
    const auto close = keeps_off ? towardHeard(senses, close_m) : std::nullopt;
    bool sinks = !close && (over || (!in_need && high)) && touchdown.maySink(senses, memory, place_m);
    if (sinks) {
        if (over && touchdown.looksAround(senses, memory, place_m, log.lean().slope(senses.base_in_map.yaw_rad))) {
            motion.yaw_rate_rad_s = settings.turn_rate_rad_s;
            sinks = height_m > looks_above_m;
        }
        motion.climb_m_s = sinks ? -touchdown.sinkRate_m_s(senses, settings) : 0.0;
    } else if (!over && above_m < off_ground_m) {
        motion = {.climb_m_s = Overhead::gentle_m_s}; // Along the ground, it would not get to another place.
    } else if (height_m > sure_of_walls_m || (overhead.hasCeiling() && height_m > hears_from_m && !straight)) {
        const double speed_m_s = hearsAhead(senses, settings.high_risk_0_m) ? 0.0 : motion.velocity_in_map_m_s.norm();
        motion = toward(senses, bearingOf(way_m), speed_m_s, settings); // It looks where it goes.
        if (height_m > sure_of_walls_m)
            makeSafe(motion);
    }
    if (close) // Wind would press it against that, and it would be turned over.
        motion = {.velocity_in_map_m_s = -away_m_s * *close};
    const double z_m = senses.position_m().z();
    column_.top_m = straight ? std::max(column_.top_m, z_m) : z_m;
    column_.come_down_m = column_.top_m - z_m;
    motion.to_ground = true;
    command(motion, port, "landing");
    if (touchdown.keptAway(senses, !sinks))
        return Descent::KeptAway;
    return sinks && touchdown.touched(senses) ? Descent::Landed : Descent::UnderWay;
}

} // namespace usar::airrobot
