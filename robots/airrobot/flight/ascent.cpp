#include "robots/airrobot/flight/ascent.h"

#include <algorithm>
#include <cmath>

namespace usar::airrobot {

namespace {

constexpr double turn_above_m = 1.0;
constexpr double turn_below_m = 2.8;
constexpr double half_turn_rad = pi; ///< The scanner sees both sides.
constexpr double look_again_m = 1.5;
/// The largest speed sideways makes the autopilot roll as far as it may; it never gets that fast in this time.
constexpr double set_off_m_s = 2.0;
constexpr Seconds setting_off{0.5};
constexpr Seconds longest_return{5.0};
constexpr double returned_m = 0.3;
constexpr double slow_m_s = 0.25;
/// It needs this much room on both sides.
constexpr double room_m = 2.5;
constexpr double level_m = 1.5; ///< above or below the robot
constexpr double tolerance_m = 0.3;
/// On a slope of 15 degrees, a sonar hears the ground where its beam is lower than this over the ground below.
constexpr double surely_no_ground_m = 1.3;
constexpr double ahead_rad = radians(60.0);
constexpr double heard_again_m = 0.2; ///< It keeps one of several things that are nearer to one another than this.
constexpr double early_m = 0.3;       ///< A look begins so much below the height up to which the air is known.
/// So little of unknown air is not worth a look: it climbs through that slowly enough to bear a touch.
constexpr double hardly_m = 1.2;

/// True if nothing beside the robot is known to be in its way as it rolls. The scan shows only what is exactly beside
/// it; what reached as high as the robot when it looked around, at most at `seen_from_m` (map z), may be as high as it
/// is now, and so may what it `heard` then. A sonar that looks to the side hears what the scan has not come to yet.
bool hasRoom(const Senses& senses, const ObstacleMemory& memory, std::span<const Obstacle> heard, double seen_from_m) {
    const Vec3 here_m = senses.position_m();
    if (nearest_m(heard, here_m.head<2>(), room_m) < room_m)
        return false;
    const auto near = memory.near(here_m.head<2>(), room_m, std::min(here_m.z(), seen_from_m) - trunk_margin_m);
    return senses.scan && std::ranges::none_of(near, [](const Obstacle& one) { return one.top_known; }) &&
           std::ranges::none_of(senses.sonars, [](const SonarEcho& one) { return one.hit && one.range_m < room_m; }) &&
           std::ranges::none_of(senses.scan->hits_in_map_m, [&](const Vec3& hit) {
               return std::abs(hit.z() - here_m.z()) < level_m && (hit - here_m).head<2>().norm() < room_m;
           });
}

} // namespace

AscentStep Ascent::step(const Senses& senses, const Vec3& goal_m, const Overhead& overhead,
                        const ObstacleMemory& memory, const Settings& settings) {
    const double z_m = senses.position_m().z();
    if (!from_z_m_) {
        from_z_m_ = z_m;
        next_look_m_ = z_m + first_look_m;
    }
    const double goal_z_m = std::min(goal_m.z(), overhead.limit_m(senses.position2_m()));
    const double error_m = goal_z_m - z_m;
    if (looking_since_) {
        const Seconds looked = senses.now - *looking_since_;
        if (looked < setting_off)
            return {.right_m_s = set_off_m_s};
        const bool back = looked >= setting_off + senses.late &&
                          (senses.position2_m() - goal_m.head<2>()).norm() < returned_m &&
                          senses.velocity_in_map_m_s.head<2>().norm() < slow_m_s;
        if (looked < longest_return + senses.late && !back)
            return {.returns = true};
        looking_since_.reset();
        next_look_m_ = z_m + look_again_m;
    }
    AscentStep step;
    const bool around = lookAround(senses, step);
    if (std::abs(error_m) < tolerance_m && around)
        return {.reached = true};
    const double known_to_m = *from_z_m_ + std::max(free_m_, known_m_ - Overhead::margin_m);
    const double free_to_m = std::max(overhead.freeTo_m(), known_to_m);
    const bool looks = z_m >= next_look_m_ && goal_z_m > free_to_m + hardly_m && z_m > free_to_m - early_m;
    // A robot that hears something near the ground knows only after its turn what stands where it would roll to.
    const bool knows = around || heard_.empty();
    if (looks && knows && hasRoom(senses, memory, heard_, *from_z_m_ + turn_below_m)) {
        looking_since_ = senses.now;
        return {.right_m_s = set_off_m_s};
    }
    const double wanted_m_s = std::clamp(error_m, -settings.descent_speed_m_s, settings.climb_speed_m_s);
    const double careful_m_s = overhead.besideWall(senses.now) ? Overhead::gentle_m_s : Overhead::careful_m_s;
    step.climb_m_s = overhead.allowed_m_s(senses, wanted_m_s, z_m >= known_to_m ? careful_m_s : wanted_m_s);
    const double known_z_m = knows ? *from_z_m_ + turn_below_m : std::min(*from_z_m_ + turn_below_m, next_look_m_);
    if (!around)
        step.climb_m_s = std::min(step.climb_m_s, std::max(0.0, known_z_m - z_m));
    return step;
}

/// Returns true if it knows what is around.
bool Ascent::lookAround(const Senses& senses, AscentStep& step) {
    const bool knows = knows_around_ || known_m_ > 0.0 || turned_rad_ >= half_turn_rad;
    if (knows || senses.position_m().z() < *from_z_m_ + turn_above_m)
        return knows;
    const double yaw_rad = senses.base_in_map.yaw_rad;
    turned_rad_ += std::abs(normalizedAngle(yaw_rad - last_yaw_rad_.value_or(yaw_rad)));
    last_yaw_rad_ = yaw_rad;
    listen(senses);
    step.looked_around = turned_rad_ >= half_turn_rad;
    step.turns = !step.looked_around;
    return step.looked_around;
}

void Ascent::listen(const Senses& senses) {
    for (const SonarEcho& echo : senses.sonars)
        if (isNoGround(echo, senses) &&
            nearest_m(heard_, echo.center_in_map_m.head<2>(), heard_again_m) >= heard_again_m)
            heard_.push_back({echo.center_in_map_m.head<2>(), echo.high_m, false});
}

bool isNoGround(const SonarEcho& echo, const Senses& senses) {
    return echo.hit && senses.ground_m && echo.low_m > *senses.ground_m + surely_no_ground_m;
}

bool hearsAhead(const Senses& senses, double within_m) {
    return std::ranges::any_of(senses.sonars, [&](const SonarEcho& echo) {
        return isNoGround(echo, senses) && echo.range_m < within_m && std::abs(echo.bearing_rad) < ahead_rad;
    });
}

double carefulClimb_m_s(const Settings& settings) {
    return std::min(settings.climb_speed_m_s, Overhead::careful_m_s);
}

} // namespace usar::airrobot
