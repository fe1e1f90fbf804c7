#include "robots/airrobot/flight/detour.h"

#include <algorithm>

namespace usar::airrobot {

namespace {

constexpr double within_m = 1.0; ///< of its goal
constexpr double ahead_m = 5.0;
constexpr Seconds plan_again{3.0};
constexpr Seconds spare_time{180.0};
constexpr double slowest_m_s = 0.25;
/// A robot that moves less than this in this time does not get past what is before it, so far away.
constexpr double moves_m = 1.0;
constexpr Seconds standing{8.0};
constexpr double nearest_goal_m = 1.0;
constexpr double farthest_m = 2.5;

} // namespace

bool Detour::start(const RouteMap& map, const Senses& senses, const Vec2& goal_m, Width width) {
    auto way = map.route(senses.position2_m(), goal_m, senses.position_m().z(), within_m);
    narrow_ = !way && width == Width::Least;
    if (narrow_)
        way = map.route(senses.position2_m(), goal_m, senses.position_m().z(), within_m, width);
    width_ = width;
    way_ = way.value_or(std::vector<Vec2>{});
    if (!way)
        return false;
    goal_m_ = goal_m;
    planned_ = senses.now;
    moved_at_ = senses.now;
    latest_ = senses.now + spare_time + Seconds(static_cast<double>(way_.size()) * grid_cell_m / slowest_m_s);
    return true;
}

Vec2 Detour::aim_m(RouteMap& map, const Senses& senses) {
    const Vec2 here_m = senses.position2_m();
    const double z_m = senses.position_m().z();
    if (senses.now - planned_ > plan_again) {
        const Seconds latest = latest_;
        const Seconds moved_at = moved_at_;
        if (map.isStraightWayFree(here_m, goal_m_, z_m) || !start(map, senses, goal_m_, width_)) {
            way_.clear();
            return goal_m_;
        }
        latest_ = latest; // A way that is found again and again must end, too.
        moved_at_ = moved_at;
    }
    dropPassed(here_m);
    learnFromStanding(map, senses);
    for (std::size_t i = way_.size(); i-- > 0;)
        if ((way_[i] - here_m).norm() <= ahead_m && map.isStraightWayFree(here_m, way_[i], z_m))
            return way_[i];
    return way_.empty() ? goal_m_ : way_.front();
}

void Detour::learnFromStanding(RouteMap& map, const Senses& senses) {
    const Vec2 here_m = senses.position2_m();
    if ((here_m - moved_to_m_).norm() > moves_m) {
        moved_to_m_ = here_m;
        moved_at_ = senses.now;
    }
    if (senses.now - moved_at_ < standing)
        return;
    moved_at_ = senses.now;
    for (const Vec2& point_m : way_)
        if (const double away_m = (point_m - here_m).norm(); away_m > nearest_goal_m && away_m < farthest_m)
            map.block(point_m, senses.position_m().z());
    planned_ = Seconds{0.0}; // It plans anew in the next tick.
}

void Detour::dropPassed(const Vec2& here_m) {
    const auto nearest = std::ranges::min_element(way_, {}, [&](const Vec2& point) { return (point - here_m).norm(); });
    way_.erase(way_.begin(), nearest);
    if (way_.size() == 1 && (way_.front() - here_m).norm() < within_m)
        way_.clear();
}

} // namespace usar::airrobot
