#include "robots/airrobot/flight/drape.h"

#include <algorithm>

namespace usar::airrobot {

namespace {

constexpr double drape_length_m = 30.0;
constexpr double drape_piece_m = 2.0;
constexpr double beyond_turn_m = 2.0; ///< So far beyond where it turns, it may come.
/// So far ahead, and so much farther for each m/s, the whole height must be reached.
constexpr double at_once_m = 4.0;
constexpr double at_once_s = 4.0;
/// The climb is planned with this share of the climb speed, which is not reached at once.
constexpr double climb_share = 0.8;
constexpr double slowest_m_s = 0.5;
/// A way is known of which so much of so many meters was seen; crowns hide the rest.
constexpr double known_share = 0.85;
constexpr double known_ahead_m = 6.0;
constexpr double over_trees_m = 16.0;

} // namespace

std::optional<double> drapedHeight_m(const HeightAtlas& atlas, const WayAhead& way, const Settings& settings) {
    const double slope = climb_share * settings.climb_speed_m_s / std::max(way.speed_m_s, slowest_m_s);
    const double whole_m = at_once_m + at_once_s * way.speed_m_s;
    const double length_m = std::min(drape_length_m, way.straight_m + beyond_turn_m);
    std::optional<double> height_m;
    for (double ahead_m = 0.0; ahead_m < length_m; ahead_m += drape_piece_m) {
        const auto top_m = atlas.highest_m({way.from_m, way.bearing_rad, ahead_m, drape_piece_m});
        if (!top_m)
            continue;
        const double needed_m = *top_m + settings.clearance_m - slope * std::max(0.0, ahead_m - whole_m);
        height_m = std::max(height_m.value_or(needed_m), needed_m);
    }
    return height_m;
}

bool maySinkFast(const HeightAtlas& atlas, const WayAhead& way, double height_m) {
    return height_m > over_trees_m || atlas.seenShare({way.from_m, way.bearing_rad, 0.0, known_ahead_m}) >= known_share;
}

} // namespace usar::airrobot
