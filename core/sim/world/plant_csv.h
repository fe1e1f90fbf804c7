// Scattered plants as a text table: thousands of trees take kilobytes here and gigabytes as SDFormat models.
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/sim/world/world.h"

namespace usar::sim {

/// Reads columns kind (`round` or `cone`: the crown), x, y, z of the base, trunk radius and height, crown radius and
/// height; meters, map frame, one plant per line after the heading line (robots-and-worlds.md, section 5). Empty lines
/// are skipped. An error names the first line that is wrong.
Result<std::vector<Plant>> readPlantCsv(const std::filesystem::path& file);
/// Writes the same format. The numbers read back exactly.
Result<void> writePlantCsv(const std::vector<Plant>& plants, const std::filesystem::path& file);

} // namespace usar::sim
