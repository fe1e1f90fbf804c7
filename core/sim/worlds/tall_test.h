// `tall_test`: 256 m x 256 m of wooded hills with a ravine, a pond and three houses.
#pragma once

#include <cstdint>

#include "core/sim/world/world.h"

namespace usar::sim {

/// Follows robots-and-worlds.md, section 5, "Procedural equivalents 1": 1025 x 1025 posts, 2000 trees, 200 bushes.
/// Woods and open stretches alternate; around `PlayerStart` (60 m x 40 m and a margin) trees are farther apart. Heights
/// are whole steps of 1/1024 m and lengths whole millimeters, so that files keep them exactly.
World makeTallTest(std::uint64_t seed);

} // namespace usar::sim
