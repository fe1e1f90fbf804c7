// Keeps together the two senses by which the robot feels things that no sensor sees and gets free of them.
#pragma once

#include "robots/airrobot/flight/belly_touch.h"
#include "robots/airrobot/flight/side_touch.h"

namespace usar::airrobot {

/// One feels what the robot rests on, and the other what holds it on its way. RingTouch feels what it climbs into.
struct Touches {
    BellyTouch belly;
    SideTouch side;
};

} // namespace usar::airrobot
