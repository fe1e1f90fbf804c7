// `vmac_room`: a closed hall with shelves and pillars, 40 m x 25 m x 6 m inside.
#pragma once

#include <cstdint>

#include "core/sim/world/world.h"

namespace usar::sim {

/// Follows robots-and-worlds.md, section 5, "Procedural equivalents 2": floor, walls, ceiling, six pillars and nine
/// shelves, all boxes. The seed determines how high the shelves are and what is on them. Six RFID tags, two victims
/// with their gas, and an alarm are there for the sensors of ground robots.
World makeVmacRoom(std::uint64_t seed);

} // namespace usar::sim
