// Where a survey is: the phases of the mission, and what belongs to one flight between two stays on the ground.
#pragma once

#include <optional>
#include <vector>

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "robots/airrobot/flight/landing.h"

namespace usar::airrobot {

/// The phase of the mission. The functions of SurveyFlight set it.
enum class Phase { Launch, TakeOff, ToLane, Lane, Home, Landing, Ground, Finished };

/// The reason why the robot is on the ground or on its way there; it determines what follows.
enum class Errand { Start, Recharge, NextSortie, Done, GivenUp };

/// What the robot has to remember from its take-off until the next one. Places are in the map frame.
struct Sortie {
    std::optional<Vec3> take_off_m{}; ///< nullopt until it takes off
    Seconds took_off{0.0};
    std::optional<Vec2> landing_m{}; ///< nullopt unless the robot is landing or on the ground after it
    std::optional<Vec2> refuge_m{};  ///< goal on the way home if it is not the base
    std::vector<Vec2> refused_m{};   ///< landing places over which it did not get, or that were no good
    Room room = Room::Usual;         ///< that a landing place must have
    Vec2 hold_m = Vec2::Zero();      ///< place to hold while paused
    bool beyond_door = false;        ///< it has flown through a door and rises, or has risen, beyond it
    bool rises_homeward = false;     ///< that was on its way home
    bool doubted_map = false;        ///< it has looked anew for ways to a goal once
    bool looked_again = false;       ///< for a way home, after there was none
    bool retraced = false;           ///< it has gone back as it came, after there was no other way home
    bool at_work = false;            ///< from reaching the scan altitude until the landing
    Seconds landed{0.0};
};

} // namespace usar::airrobot
