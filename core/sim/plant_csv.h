// Scattered plants as a table of text: thousands of trees cost kilobytes here and gigabytes as SDFormat models.
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"
#include "core/sim/world.h"

namespace usar::sim {

/// Columns kind (`round` or `cone`: the crown), x, y, z of the base, trunk radius and height, crown radius and height;
/// metres, map frame, one plant a line after the heading line (robots-and-worlds, section 5). Empty lines are skipped.
/// Refuses with the number of the first line that is wrong.
Result<std::vector<Plant>> readPlantCsv(const std::filesystem::path& file);
/// Reads back equal, number by number.
Result<void> writePlantCsv(const std::vector<Plant>& plants, const std::filesystem::path& file);

} // namespace usar::sim
