// Height maps as 16-bit grayscale PNG, value by value: no gamma, no scaling.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/result.h"

namespace usar::sim {

/// Rows from the top of the picture down: as a map, north (highest y) first.
struct HeightImage {
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::vector<std::uint16_t> values;
    bool operator==(const HeightImage&) const = default;
};

/// Refuses everything that is not 16-bit grayscale, damaged files, and sides above 16385.
Result<HeightImage> readHeightPng(const std::filesystem::path& file);
/// `values.size()` is columns * rows. Equal images give equal bytes.
Result<void> writeHeightPng(const HeightImage& image, const std::filesystem::path& file);

} // namespace usar::sim
