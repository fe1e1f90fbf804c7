#include "robots/airrobot/flight/column.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robots/airrobot/flight/climb_over.h"

namespace usar::airrobot {

namespace {

/// Nothing at the robot's height or above may be nearer to its center; the ring's radius is half a meter.
constexpr double too_near_m = 1.0;
/// The flat underside of a crown came from 2 m to the ring within 0.8 s of a climb at 0.3 m/s
/// (`tst_random_surveys_campaign`, number 114144).
constexpr double close_m = 2.2;
constexpr double closing_m_s = 1.25;
constexpr int closing_ticks = 2;
constexpr int closing_sonars = 2; ///< A turn along one slanted side sweeps a single one over it.
constexpr Seconds longest_tick{0.5};
constexpr double crowded_climb_m = 4.0; ///< It turns as it climbs where something stands within this distance.
constexpr double enough_room_m = 3.0;   ///< More room than this is not sought.
constexpr double sought_within_m = 5.0;
constexpr double search_step_m = 0.5;
constexpr double failed_passed_m = 0.5; ///< A robot so far above the place where a climb has failed has got past it.
constexpr double below_failed_m = 1.5;  ///< One that is lower than this can still climb fast.
constexpr int search_bearings = 24;
constexpr double way_cost = 0.1; ///< meters of room that a meter of way must bring
constexpr double move_half_width_m = 0.6;
constexpr double level_with_m = 0.5; ///< A thing lower or higher by more than this is not beside the robot.
/// A full turn takes as long as a climb of 3 m, and the sonars look forward: what they heard so far below may go on up,
/// and was not looked at since then (random survey 167626).
constexpr double turns_over_m = 2.0;
constexpr double overhangs_m = 2.0; ///< A thing higher than this above the robot does not matter yet.
constexpr double matters_m = 8.0;
constexpr double surely_heard_m = 3.5; ///< A sonar does not say from where in its cone a farther echo came.
constexpr double same_m = 0.3;
constexpr std::size_t most_met = 400;
constexpr double back_off_m = 0.8;
constexpr double back_off_m_s = 0.5;
constexpr double lowest_m = 2.2; ///< over the ground
constexpr double farthest_column_m = 6.5;
constexpr double half_way_m = 0.75;
constexpr double beside_roof_m = 4.0;  ///< A ceiling that is a floor on posts may end so far away.
constexpr double beside_tried_m = 2.0; ///< So near to a place where it has tried to climb, it does not try again.

/// The place nearby with the most room between all `things` and apart from the places where it `failed`, to which
/// nothing `beside` stands in the way.
Vec2 roomiest_m(std::span<const Obstacle> things, std::span<const Obstacle> beside, std::span<const Vec3> failed,
                const Vec2& here_m) {
    Vec2 best_m = here_m;
    double best = roomForClimb_m(things, here_m, enough_room_m, failed);
    for (double away_m = search_step_m; away_m <= sought_within_m; away_m += search_step_m)
        for (int i = 0; i < search_bearings; ++i) {
            const double bearing_rad = 2.0 * pi * i / search_bearings;
            const Vec2 place_m = here_m + away_m * Vec2(std::cos(bearing_rad), std::sin(bearing_rad));
            const double score = roomForClimb_m(things, place_m, enough_room_m, failed) - way_cost * away_m;
            if (score > best && clearance_m(beside, here_m, bearing_rad, move_half_width_m, away_m) >= away_m) {
                best = score;
                best_m = place_m;
            }
        }
    return best_m;
}

} // namespace

void Column::moveTo(const Vec2& place_m, Seconds now) {
    at_m = place_m;
    moving_since = now;
    there = false;
    const auto near = [&](const Vec3& one_m) { return (one_m.head<2>() - place_m).norm() < in_column_m; };
    if (std::ranges::any_of(failed_m_, near))
        tries_ = most_tries;
}

bool Column::mayMeetAgain(const Vec3& here_m) const {
    return std::ranges::any_of(failed_m_, [&](const Vec3& one_m) {
        return (one_m - here_m).head<2>().norm() < sought_within_m && here_m.z() < one_m.z() + failed_passed_m &&
               here_m.z() > one_m.z() - below_failed_m;
    });
}

void Column::listen(const Senses& senses) {
    for (const SonarEcho& echo : senses.sonars) {
        const auto same = [&](const Vec3& one_m) { return (one_m - echo.center_in_map_m).norm() < same_m; };
        if (isNoGround(echo, senses) && echo.range_m < surely_heard_m && met_m_.size() < most_met &&
            std::ranges::none_of(met_m_, same))
            met_m_.push_back(echo.center_in_map_m);
    }
}

bool Column::closesIn(const Senses& senses) {
    const Seconds since = senses.now - std::exchange(listened_at_, senses.now);
    int sonars = 0;
    for (const SonarEcho& echo : senses.sonars) {
        const double range_m = isNoGround(echo, senses) ? echo.range_m : echo.maximum_m;
        Closing& one = closing_[echo.name];
        const bool nearer =
            range_m < close_m && since < longest_tick && one.range_m - range_m > closing_m_s * since.count();
        one = {range_m, nearer ? one.ticks + 1 : 0};
        sonars += one.ticks >= closing_ticks ? 1 : 0;
    }
    return sonars >= closing_sonars;
}

Column::Minding Column::mind(const Senses& senses, std::span<const Obstacle> known, const Vec2& slope,
                             double commanded_m_s) {
    const Vec3 here_m = senses.position_m();
    listen(senses);
    std::vector<Obstacle> things(known.begin(), known.end());
    std::vector<Obstacle> beside;
    const auto add = [&](const Vec3& thing_m) {
        const double over_m = thing_m.z() - here_m.z();
        if (over_m < -level_with_m || over_m > overhangs_m || (thing_m - here_m).head<2>().norm() > matters_m)
            return;
        things.push_back({thing_m.head<2>(), thing_m.z(), true});
        if (over_m < level_with_m)
            beside.push_back(things.back());
    };
    double passed_m = matters_m; // to what it has heard and climbed past
    for (const Vec3& one_m : met_m_) {
        add(one_m);
        if (std::abs(one_m.z() - here_m.z()) < turns_over_m)
            passed_m = std::min(passed_m, (one_m - here_m).head<2>().norm());
    }
    if (senses.scan)
        std::ranges::for_each(senses.scan->hits_in_map_m, add);
    const double room_m = nearest_m(things, here_m.head<2>(), matters_m);
    const bool climbs = commanded_m_s >= RingTouch::least_climb_m_s;
    const auto met_m = sinks_to_m_ ? std::nullopt : touch_.feel(senses, slope, commanded_m_s);
    if (met_m)
        met_m_.push_back(*met_m);
    const bool closes_in = closesIn(senses);
    if (!sinks_to_m_ && (met_m || (climbs && (room_m < too_near_m || closes_in)))) {
        ++tries_;
        failed_m_.push_back(here_m);
        sinks_to_m_ = std::max(here_m.z() - back_off_m, senses.ground_m.value_or(here_m.z()) + lowest_m);
    }
    if (sinks_to_m_ && here_m.z() > *sinks_to_m_)
        return {.at_most_m_s = -back_off_m_s};
    if (sinks_to_m_) {
        sinks_to_m_.reset();
        moveTo(roomiest_m(things, beside, failed_m_, here_m.head<2>()), senses.now);
        return {.at_most_m_s = 0.0};
    }
    return std::min(room_m, passed_m) < crowded_climb_m ? Minding{Overhead::gentle_m_s, true} : Minding{};
}

Vec2 otherColumn_m(std::span<const Obstacle> near, const Vec2& here_m, const Overhead& overhead,
                   std::span<const Vec2> tried_m) {
    Vec2 best_m = here_m;
    double best = 0.0;
    for (double away_m = 1.0; away_m <= farthest_column_m; away_m += 0.5)
        for (int i = 0; i < search_bearings; ++i) {
            const double bearing_rad = 2.0 * pi * i / search_bearings;
            const Vec2 at_m = here_m + away_m * Vec2(std::cos(bearing_rad), std::sin(bearing_rad));
            const bool tried = std::ranges::any_of(
                tried_m, [&](const Vec2& other_m) { return (other_m - at_m).norm() < beside_tried_m; });
            if (tried || nearest_m(near, at_m, farthest_column_m) < room_to_climb_m ||
                clearance_m(near, here_m, bearing_rad, half_way_m, away_m) < away_m)
                continue;
            const double gain = overhead.nearestFind_m(at_m, beside_roof_m) - way_cost * away_m;
            if (gain > best) {
                best = gain;
                best_m = at_m;
            }
        }
    return best_m;
}

} // namespace usar::airrobot
