#include "robots/airrobot/flight/climb_over.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace usar::airrobot {

namespace {

constexpr double body_half_width_m = 0.9;
constexpr double search_m = 6.0;
constexpr int bearings = 16;
constexpr double detour_cost = 0.15;
constexpr double unknown_cost_m = 1.0; ///< so much more room a place must have where the robot has not flown
constexpr Seconds backing_time{8.0};
constexpr double arrived_m = 0.4;
constexpr double free_way_m = 6.0;
constexpr double free_half_width_m = 1.5;
constexpr double front_rad = radians(45.0);
constexpr double facing_rad = 0.3;
/// How far the robot continues to climb after the way is free, so that its belly clears the top.
constexpr double extra_m = 1.5;
constexpr double sinks_by_m = 0.8;   ///< from where its ring has met something
constexpr double free_of_it_m = 0.3; ///< A robot that has sunk so far is free of that.
constexpr double sinks_m_s = 0.5;
constexpr double sinks_to_height_m = 2.2; ///< over the ground, at least
constexpr Seconds longest_sinking{4.0};
constexpr std::size_t most_met_climbing = 4;
constexpr double room_where_failed_m = 0.7;
constexpr double failed_near_m = 0.7; ///< So near to where a climb has failed, another one would fail, too.
constexpr double below_m = 0.15;      ///< distance from the greatest height at which the climb ends

} // namespace

double roomForClimb_m(std::span<const Obstacle> things, const Vec2& at_m, double enough_m,
                      std::span<const Vec3> failed_m) {
    double room_m = nearest_m(things, at_m, enough_m);
    for (const Vec3& one_m : failed_m)
        room_m = std::min(room_m, (one_m.head<2>() - at_m).norm() + room_where_failed_m);
    return room_m;
}

Vec2 climbPlace_m(std::span<const Obstacle> obstacles, const Vec2& here_m, double standoff_m, const Retreat& retreat,
                  std::span<const Vec3> failed_m) {
    Vec2 best_m = here_m;
    double best_score = roomForClimb_m(obstacles, here_m, standoff_m, failed_m);
    for (double distance_m = 1.0; distance_m <= search_m; distance_m += 1.0) {
        for (int i = 0; i < bearings; ++i) {
            const double bearing_rad = 2.0 * pi * i / bearings;
            if (clearance_m(obstacles, here_m, bearing_rad, body_half_width_m, distance_m) < distance_m)
                continue;
            const Vec2 place_m = here_m + distance_m * Vec2(std::cos(bearing_rad), std::sin(bearing_rad));
            const double risk_m = !retreat.flown || retreat.flown(place_m) ? 0.0 : unknown_cost_m;
            const double score =
                roomForClimb_m(obstacles, place_m, standoff_m, failed_m) - detour_cost * distance_m - risk_m;
            if (score > best_score) {
                best_score = score;
                best_m = place_m;
            }
        }
    }
    return best_m;
}

void ClimbOver::start(const Senses& senses, std::span<const Obstacle> obstacles, const Settings& settings,
                      const Retreat& retreat) {
    if (state_ != ClimbState::Sinking) { // Another climb met that.
        met_.clear();
        failed_m_.clear();
    }
    std::vector<Obstacle> known(obstacles.begin(), obstacles.end());
    known.insert(known.end(), met_.begin(), met_.end());
    state_ = ClimbState::Backing;
    place_m_ = climbPlace_m(known, senses.position2_m(), settings.climb_standoff_m, retreat, failed_m_);
    since_ = senses.now;
    free_since_z_m_.reset();
}

void ClimbOver::feel(const Senses& senses, const Vec2& slope, double commanded_m_s, const Settings& settings) {
    // A robot that is told to climb faster does so a moment later, and nothing holds it.
    const double followed_m_s = std::min(commanded_m_s, std::exchange(commanded_m_s_, commanded_m_s));
    const auto met_m = touch_.feel(senses, slope, state_ == ClimbState::Climbing ? followed_m_s : 0.0);
    if (!met_m)
        return;
    met_.push_back({met_m->head<2>(), met_m->z(), true});
    failed_m_.push_back(senses.position_m());
    state_ = ClimbState::Sinking;
    since_ = senses.now;
    const double lowest_m = std::max(settings.floor_level_m, senses.ground_m.value_or(-1e9) + sinks_to_height_m);
    sinks_to_m_ = std::max(senses.position_m().z() - sinks_by_m, lowest_m);
    if (touch_.onlyHears()) // It was free where it began.
        sinks_to_m_ = std::max(sinks_to_m_, begins_m_);
}

bool ClimbOver::mayBePressed(double z_m) const {
    return sinks() && !failed_m_.empty() && z_m > failed_m_.back().z() - free_of_it_m;
}

/// Ends the climb or begins it anew, farther from all that it has met, once the robot has sunk.
void ClimbOver::sink(const Senses& senses, std::span<const Obstacle> obstacles, const Settings& settings) {
    if (senses.position_m().z() > sinks_to_m_ && senses.now - since_ < longest_sinking)
        return;
    if (met_.size() < most_met_climbing)
        start(senses, obstacles, settings);
    const auto near = [&](const Vec3& one_m) { return (one_m.head<2>() - place_m_).norm() < failed_near_m; };
    if (met_.size() >= most_met_climbing || std::ranges::any_of(failed_m_, near))
        state_ = ClimbState::Failed;
}

bool ClimbOver::wayIsFree(const Senses& senses, const ThreatPicture& picture, std::span<const Obstacle> obstacles,
                          const Vec2& goal_m) const {
    const Vec2 way_m = goal_m - senses.position2_m();
    const double bearing_rad = bearingOf(way_m);
    if (std::abs(normalizedAngle(bearing_rad - senses.base_in_map.yaw_rad)) > facing_rad)
        return false;
    for (const agent::SonarZone& zone : picture.zones)
        if (std::abs(zone.bearing_rad) < front_rad && zone.risk != agent::Risk::None)
            return false;
    const double needed_m = std::min(free_way_m, way_m.norm());
    return clearance_m(obstacles, senses.position2_m(), bearing_rad, free_half_width_m, needed_m) >= needed_m;
}

ClimbStep ClimbOver::step(const Senses& senses, const ThreatPicture& picture, std::span<const Obstacle> obstacles,
                          const Vec2& goal_m, double highest_m, const Settings& settings) {
    if (state_ == ClimbState::Sinking) {
        sink(senses, obstacles, settings);
        return {state_, place_m_, state_ == ClimbState::Sinking ? -sinks_m_s : 0.0};
    }
    if (state_ == ClimbState::Backing) {
        const bool there = (senses.position2_m() - place_m_).norm() < arrived_m;
        if (there || senses.now - since_ > backing_time / senses.steadyShare()) {
            state_ = ClimbState::Climbing;
            place_m_ = senses.position2_m();
            begins_m_ = senses.position_m().z();
        }
        return {state_, place_m_, 0.0};
    }
    if (state_ != ClimbState::Climbing)
        return {state_, place_m_, 0.0};
    const double z_m = senses.base_in_map.position_m.z();
    if (!wayIsFree(senses, picture, obstacles, goal_m))
        free_since_z_m_.reset();
    else if (!free_since_z_m_)
        free_since_z_m_ = z_m;
    else if (z_m - *free_since_z_m_ > extra_m)
        state_ = ClimbState::Over;
    // Where no ground is within the scanner's reach, the floor level stands in for it.
    const double height_m = senses.heightOverGround_m(z_m - settings.floor_level_m);
    // Below a ceiling there may be less room than that, and what is in the way may still pass below.
    if (height_m >= settings.maximum_height_m || z_m > highest_m - below_m)
        state_ = free_since_z_m_ ? ClimbState::Over : ClimbState::Failed;
    return {state_, place_m_, settings.climb_speed_m_s / 2.0};
}

} // namespace usar::airrobot
