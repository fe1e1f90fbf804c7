// `volcano`: a real hill with a crater, 860 m x 600 m, from measured heights.
#pragma once

#include <cstdint>

#include "core/sim/world.h"
#include "core/sim/worlds/elevation_csv.h"

namespace usar::sim {

/// What separates the world from its source at the source's posts, at most.
inline constexpr double volcano_noise_m = 0.4;
inline constexpr double volcano_post_m = 10.0; ///< of the source

/// After robots-and-worlds, section 5, "Procedural equivalents 5": cubic splines through the source's posts, sampled
/// each 0.5 m, with a little noise of less than 10 m in size that dies away where robots start. The table's rows run to
/// the north, which is x, its columns to the west, which is y; heights are above the sea. 300 trees.
World makeVolcano(const ElevationTable& source, std::uint64_t seed);

} // namespace usar::sim
