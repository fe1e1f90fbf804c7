// World folders to worlds: <name>/world.sdf (SDFormat 1.9) and, where it names them, height.png (16 bit), plants.csv.
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/sim/world.h"

namespace usar::sim {

/// Refuses with file, line where known, and reason. Loads through libsdformat; its own messages become the error's.
Result<World> readWorld(const std::filesystem::path& folder);

} // namespace usar::sim
