#include "robots/airrobot/flight/ways.h"

#include <algorithm>

namespace usar::airrobot {

namespace {

/// Doors are higher than this, from the base of a robot that stands. It flies a margin lower through them.
constexpr double low_room_m = 3.2;
constexpr double on_floor_m = 0.4;    ///< Ground is not higher than this over the base of a robot that stands.
constexpr double beyond_door_m = 3.5; ///< behind what ends the ways higher up
constexpr double way_end_m = 1.0;     ///< from the ground behind a door, where a way to it may end
constexpr double sink_open_m = 1.25;  ///< Where it sinks, so much ground around it was seen,
constexpr double sink_room_m = 1.5;   ///< and nothing is known to stand so near to it, however high.
constexpr double low_enough_m = 0.15; ///< It flies on once it is no farther than this above where it is to fly.
constexpr double over_sink_m = 1.0;   ///< It sinks no farther from its place than this.
constexpr double aside_m = 1.2;       ///< So far it moves aside from what it has touched there.
constexpr double below_lid_m = 0.5;   ///< Scanner hits that are higher are over the robot.
/// A robot that flies slowly may come so much nearer than the settings say.
constexpr double nearness = 0.55;
/// It hesitates if it has stayed within this distance for so long.
constexpr double moves_on_m = 1.0;
constexpr Seconds hesitating{5.0};
constexpr double past_it_m = 3.0; ///< So far from there, it flies as usual again.

} // namespace

void Ways::startAnew(double base_z_m) {
    high_.clear();
    low_.clear();
    lid_m_ = base_z_m + low_room_m;
    under_ = near_ = squeezes_ = hesitates_ = false;
}

void Ways::take(const Senses& senses, double below_m, bool sure, bool roofed) {
    const double z_m = senses.position_m().z();
    sunk_ = z_m < lid_m_ && (sunk_ || z_m < lid_m_ - Overhead::margin_m + low_enough_m);
    if (sure)
        map().take(senses, below_m);
    if (senses.scan && roofed && !under_)
        low_.takeBand(*senses.scan, {lid_m_ - Overhead::margin_m - passes_closer_m, lid_m_ - below_lid_m});
}

std::optional<Vec2> Ways::groundBehindDoor_m(const Vec2& from_m, const ReachablePlaces& higher_up) const {
    return low_.groundBeyond_m(from_m, lid_m_ - Overhead::margin_m, lid_m_ - low_room_m + on_floor_m, higher_up,
                               beyond_door_m);
}

std::optional<Vec2> Ways::placeToSink_m(const Vec2& from_m, const Vec2& ground_m, const ReachablePlaces& higher_up,
                                        const ObstacleMemory& memory) const {
    auto way = low_.route(from_m, ground_m, lid_m_ - Overhead::margin_m, way_end_m, Width::Least);
    if (!way)
        return std::nullopt;
    const double floor_m = lid_m_ - low_room_m + on_floor_m;
    const auto is_open = [&](const Vec2& at_m) {
        return higher_up.contains(at_m) && low_.isOpenGround(at_m, sink_open_m, floor_m) &&
               memory.near(at_m, sink_room_m, floor_m).empty();
    };
    const auto last = std::ranges::find_if(way->rbegin(), way->rend(), is_open);
    return last == way->rend() ? std::nullopt : std::optional(*last);
}

void Ways::goUnder(const Vec2& place_m, Overhead& overhead) {
    under_ = true;
    sunk_ = false;
    sink_at_m_ = place_m;
    overhead.putLid(lid_m_);
}

void Ways::comeUp(Overhead& overhead) {
    under_ = false;
    overhead.putLid(std::nullopt);
}

void Ways::touch(const Senses& senses, const Vec2& touched_m) {
    if (under_ && !sunk_)
        sink_at_m_ = senses.position2_m() + aside_m * (senses.position2_m() - touched_m).normalized();
}

std::optional<Motion> Ways::sink(const Senses& senses) const {
    if (!under_ || sunk_)
        return std::nullopt;
    Motion motion = holding(senses, sink_at_m_);
    // It flies straight to its place, and may touch something before that.
    motion.velocity_in_map_m_s *= std::min(1.0, door_m_s / std::max(door_m_s, motion.velocity_in_map_m_s.norm()));
    if ((senses.position2_m() - sink_at_m_).norm() < over_sink_m)
        motion.climb_m_s = -Overhead::gentle_m_s; // A rack or a beam may be below.
    return motion;
}

void Ways::noteProgress(Seconds now, const Vec2& here_m) {
    const bool asked_lately = now - asked_at_ < hesitating;
    asked_at_ = now;
    if (!asked_lately || (here_m - moved_to_m_).norm() > (hesitates_ ? past_it_m : moves_on_m)) {
        hesitates_ = false;
        moved_to_m_ = here_m;
        moved_at_ = now;
    }
    hesitates_ = hesitates_ || now - moved_at_ > hesitating;
}

Settings Ways::forThreats(Settings settings) const {
    for (double* range_m :
         {&settings.low_risk_0_m, &settings.low_risk_1_m, &settings.low_risk_2_m, &settings.low_risk_3_m,
          &settings.low_risk_4_m, &settings.high_risk_0_m, &settings.high_risk_1_m, &settings.high_risk_2_m,
          &settings.high_risk_3_m, &settings.high_risk_4_m})
        *range_m *= isNarrow() ? nearness : 1.0;
    return settings;
}

} // namespace usar::airrobot
