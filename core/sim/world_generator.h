// Makes the worlds that come with the program, reproducibly from a seed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/sim/world.h"

namespace usar::sim {

/// Names that `makeWorld` knows.
std::vector<std::string> generatedWorldNames();

/// Equal seeds give equal worlds. `data` is the folder of measured data that worlds after real places are made from:
/// resources/worlds of the sources.
Result<World> makeWorld(const std::string& name, std::uint64_t seed, const std::filesystem::path& data);

/// Writes world.sdf and what it needs into `folder` (made if missing). Equal seeds give equal bytes.
Result<void> generateWorld(const std::string& name, std::uint64_t seed, const std::filesystem::path& data,
                           const std::filesystem::path& folder);

} // namespace usar::sim
