// Writes world folders that world_reader.h reads.
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/sim/world/world.h"

namespace usar::sim {

/// Smallest step between two heights in a height map.
inline constexpr double finest_height_step_m = 1.0 / 1024.0;

/// Writes world.sdf and, if the world needs them, height.png and plants.csv into `folder`, which is created if missing.
/// Equal worlds give equal bytes. Heights are stored above the whole meter at or below the lowest, in steps of 1/1024
/// m, or of the next power of two that reaches the highest: 1/512 m from 63 m of relief on, 1/256 m from 127 m on.
/// Heights that are multiples of the step are kept exactly.
Result<void> writeWorld(const World& world, const std::filesystem::path& folder);

} // namespace usar::sim
