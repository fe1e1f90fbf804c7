// Keeps together the senses by which the robot feels things that no sensor sees and gets free of them.
#pragma once

#include "robots/airrobot/flight/belly_touch.h"
#include "robots/airrobot/flight/side_touch.h"
#include "robots/airrobot/flight/top_touch.h"

namespace usar::airrobot {

/// They feel what the robot rests on, what holds it on its way, and what it climbs into on its way. RingTouch feels
/// what it climbs into where it goes straight up.
struct Touches {
    BellyTouch belly;
    SideTouch side;
    TopTouch top;
};

} // namespace usar::airrobot
