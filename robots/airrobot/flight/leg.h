// What the robot is to do in one tick of flight, and what becomes of it.
#pragma once

#include <optional>
#include <string>

#include "core/base/geometry.h"
#include "robots/airrobot/flight/route_map.h"

namespace usar::airrobot {

/// Where and how to fly in one tick. Places are in the map frame.
struct Leg {
    Vec2 goal_m = Vec2::Zero(); ///< point to reach
    Vec2 aim_m = Vec2::Zero();  ///< point to steer at on the way there
    double speed_m_s = 1.0;
    std::string source;          ///< named as the cause of the commands
    Width width = Width::Usual;  ///< Ways may be as narrow as this.
    std::optional<Vec2> end_m{}; ///< where the straight way ends if it goes on beyond the goal
};

/// The result of one tick of flight. Unreachable: the goal should be given up.
enum class FlightState { Flying, Evading, ClimbingOver, Unreachable };

/// The ways to fly in one tick.
enum class Maneuver {
    Cruise,   ///< along the leg, over and around known obstacles
    Avoid,    ///< away from a high risk, around a low one, or waiting between two
    ClimbOver ///< away from the obstacle, straight up, then across
};

} // namespace usar::airrobot
