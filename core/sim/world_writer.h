// Worlds to world folders, for the reader in world_reader.h.
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/sim/world.h"

namespace usar::sim {

inline constexpr double finest_height_step_m = 1.0 / 1024.0;

/// Writes world.sdf and, where the world needs them, height.png and plants.csv; equal worlds give equal bytes. Heights
/// are stored from a whole metre below the lowest in steps of 1/1024 m, or of the next power of two that reaches the
/// highest: 1/512 m from 63 m of relief up, 1/256 m from 127 m up. Heights that are such steps are kept exactly.
Result<void> writeWorld(const World& world, const std::filesystem::path& folder);

} // namespace usar::sim
