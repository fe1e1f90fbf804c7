// What the robot feels of things that no sensor sees.
#pragma once

#include "robots/airrobot/flight/belly_touch.h"
#include "robots/airrobot/flight/side_touch.h"

namespace usar::airrobot {

/// What it touches from above, and on its way. RingTouch feels what is over it in a climb.
struct Touches {
    BellyTouch belly;
    SideTouch side;
};

} // namespace usar::airrobot
