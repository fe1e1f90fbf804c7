// The part of a world that a flying robot can get to from its start.
#pragma once

#include "core/base/reach.h"
#include "core/sim/world/world.h"

namespace usar::sim {

/// Fills the air of the true world from the start on, over columns of at most 1 m: between 1 m over the ground (or over
/// water) and the greatest height of the flight, wherever the body touches no box. Boxes that never move are walls,
/// buildings and ceilings; plants are flown around or over, and things that can be pushed are no obstacle. A place
/// counts as scanned if the body gets so near to it that nothing solid is in between: beside a wall, too. Range sensors
/// do not see water, so the bottom of a pond counts as scanned, too, if the scan altitude over it is above the water.
/// Takes about a second for a square kilometer; the result keeps what it needs of the world. It knows start and area
/// and their surroundings up to 10 m; ways may lead around them for up to 100 m. The result is empty if there is no air
/// at the start, or if all of this is larger than 16 square kilometers.
ReachMap reachFrom(const World& world, const FlightLimits& flight, const Rectangle& area_in_map);

} // namespace usar::sim
