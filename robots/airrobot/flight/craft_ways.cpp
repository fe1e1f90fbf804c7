#include "robots/airrobot/flight/craft.h"

#include <utility>

namespace usar::airrobot {

namespace {

constexpr double least_climb_m = 1.0; ///< A climb over an obstacle needs this much room below a ceiling.
/// A climb over something needs this share of the stand-off at its place.
constexpr double least_room_share = 0.85;
/// A robot that is hindered for so long looks for a detour, and again after the same time.
constexpr Seconds patience{6.0};
/// A robot that does not get on takes the place so far before it for closed, and goes back by `leaves_m`.
constexpr double blocked_ahead_m = 1.5;
constexpr double leaves_m = 3.0;

} // namespace

void Craft::noteGoal(const Leg& leg) {
    const Vec2& goal_m = leg.goal_m;
    if (goal_m_ && (*goal_m_ - goal_m).norm() < 0.5)
        return;
    if (std::exchange(goal_m_, goal_m))
        no_way_before_ = false; // The last goal was reached.
    no_way_ = false;
    detour_.end();
    if (no_way_before_ && !ways.map().isStraightWayFree(senses.position2_m(), goal_m, senses.position_m().z()))
        no_way_ = !detour_.start(ways.map(), senses, goal_m, leg.width) && !mayClimb();
}

bool Craft::mayClimb() const {
    const double room_m = overhead.limit_m(senses.position2_m()) - senses.position_m().z();
    return settings.climb_over && room_m > least_climb_m;
}

void Craft::findWay(const Leg& leg, bool hindered) {
    const bool leaves = hindered && !mayClimb() && !way_back_.active();
    if (leaves && way_back_.isPinned()) {
        way_back_.begin();
        detour_.end();
        return;
    }
    if (leaves && way_back_.stands()) {
        const Vec2 here_m = senses.position2_m();
        ways.map().block(here_m + blocked_ahead_m * (detour_aim_m_ - here_m).normalized(), senses.position_m().z());
        plans_after_way_back_ = way_back_.begin(0.0, leaves_m);
        detour_.end();
        return;
    }
    if (!mayClimb() && !way_back_.active() && std::exchange(plans_after_way_back_, false)) {
        no_way_ = !detour_.start(ways.map(), senses, leg.goal_m, leg.width);
        return;
    }
    if (!hindered || climb_over_.active() || detour_.active() || way_back_.active())
        return;
    if (mayClimb()) {
        if (stuck_.hindered() > Seconds(settings.climb_over_after_s))
            findClimb();
        return;
    }
    if (stuck_.hindered() < patience || senses.now - looked_for_way_ < patience)
        return;
    looked_for_way_ = senses.now;
    no_way_ = !detour_.start(ways.map(), senses, leg.goal_m, leg.width);
}

/// Climbs nearby. In a hurry, it has come among crowns faster than it could look at them, and they get wider on the way
/// up: where there is no room, it goes back to where it came from, and climbs there.
void Craft::findClimb() {
    const Vec2 place_m = climbPlace_m(obstacles_, senses.position2_m(), settings.climb_standoff_m, retreat());
    const double room_m = nearest_m(obstacles_, place_m, settings.climb_standoff_m);
    plans_after_way_back_ = settings.hurried() && room_m < least_room_share * settings.climb_standoff_m &&
                            way_back_.begin(settings.climb_standoff_m);
    if (!plans_after_way_back_)
        climb_over_.start(senses, obstacles_, settings, retreat());
}

} // namespace usar::airrobot
