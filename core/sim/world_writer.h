// Worlds to world folders, for the reader in world_reader.h.
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/sim/world.h"

namespace usar::sim {

/// Writes world.sdf, height.png and plants.csv; equal worlds give equal bytes. Heights are stored in steps of 1/1024 m
/// from a whole metre below the lowest: exact when they are such steps already, and refused beyond 63 m of relief.
Result<void> writeWorld(const World& world, const std::filesystem::path& folder);

} // namespace usar::sim
