// Tables of measured heights, which worlds that follow real places are made from.
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "core/base/result.h"

namespace usar::sim {

/// Rows are lines of the file, columns are numbers in a line.
struct ElevationTable {
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::vector<double> heights_m; ///< row by row

    double at(std::size_t row, std::size_t column) const { return heights_m[row * columns + column]; }
};

/// Reads lines of equally many numbers with commas between them, at least 4 x 4. An error names the wrong line.
Result<ElevationTable> readElevationCsv(const std::filesystem::path& file);

} // namespace usar::sim
