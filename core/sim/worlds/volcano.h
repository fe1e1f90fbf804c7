// `volcano`: a real hill with a crater, 860 m x 600 m, from measured heights.
#pragma once

#include <cstdint>

#include "core/sim/world/world.h"
#include "core/sim/worlds/elevation_csv.h"

namespace usar::sim {

/// Largest difference between the world and its source at the source's posts.
inline constexpr double volcano_noise_m = 0.4;
inline constexpr double volcano_post_m = 10.0; ///< distance between the source's posts

/// Follows robots-and-worlds.md, section 5, "Procedural equivalents 5": cubic splines through the source's posts,
/// sampled every 0.5 m, with a little noise on scales below 10 m that fades out where robots start. The table's rows
/// run to the north, which is x, and its columns to the west, which is y; heights are above sea level. 300 trees.
World makeVolcano(const ElevationTable& source, std::uint64_t seed);

} // namespace usar::sim
