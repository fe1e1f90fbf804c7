// `point_lookout`: a square kilometer of sea around a wooded island with cliffs and beaches.
#pragma once

#include <cstdint>

#include "core/sim/world/world.h"

namespace usar::sim {

/// Follows robots-and-worlds.md, section 5, "Procedural equivalents 3": 1025 x 1025 posts 1 m apart, the sea's surface
/// at 0 and its bed down to -25 m, 3000 trees on land. The start poses `OpenSea`, `NorthSea` and `Bay` are a meter
/// above deep water, for a submarine to fall in. Heights are whole steps of 1/512 m.
World makePointLookout(std::uint64_t seed);

} // namespace usar::sim
