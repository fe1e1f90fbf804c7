// Generates the worlds that come with the program, reproducibly from a seed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/sim/world/world.h"

namespace usar::sim {

/// Names of the worlds that `makeWorld` can generate.
std::vector<std::string> generatedWorldNames();

/// Succeeds if `makeWorld` can generate a world of this name; the error lists the names.
Result<void> checkGenerator(const std::string& name);

/// Generates a world; equal seeds give equal worlds. `data` is the folder of measured data for worlds that follow real
/// places: resources/worlds of the source tree. Fails if the name is unknown or the data cannot be read.
Result<World> makeWorld(const std::string& name, std::uint64_t seed, const std::filesystem::path& data);

/// Writes world.sdf and the files it refers to into `folder`, which is created if missing. Equal seeds give equal
/// bytes.
Result<void> generateWorld(const std::string& name, std::uint64_t seed, const std::filesystem::path& data,
                           const std::filesystem::path& folder);

} // namespace usar::sim
