// Reads world folders: <name>/world.sdf (SDFormat 1.9) and, if it names them, height.png (16 bit) and plants.csv.
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/sim/world/world.h"

namespace usar::sim {

/// Reads one world, which needs some ground and a start pose. An error names the file, the line if known, and the
/// reason. libsdformat parses the file; its own messages become the error's.
Result<World> readWorld(const std::filesystem::path& folder);

} // namespace usar::sim
