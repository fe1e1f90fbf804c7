// Makes the worlds that come with the program, reproducibly from a seed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace usar::sim {

/// Names that `generateWorld` knows.
std::vector<std::string> generatedWorldNames();

/// Writes world.sdf, height.png and plants.csv into `folder` (made if missing). Equal seeds give equal bytes.
Result<void> generateWorld(const std::string& name, std::uint64_t seed, const std::filesystem::path& folder);

} // namespace usar::sim
