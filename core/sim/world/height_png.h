// Height maps as 16-bit grayscale PNG, value by value: no gamma, no scaling.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/result.h"

namespace usar::sim {

/// Rows go from the top of the picture down, the one with the highest y first.
struct HeightImage {
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::vector<std::uint16_t> values;
    bool operator==(const HeightImage&) const = default;
};

/// Fails for anything that is not 16-bit grayscale, for damaged files, and for sides above 16385 pixels.
Result<HeightImage> readHeightPng(const std::filesystem::path& file);
/// `values.size()` must be columns * rows. Equal images give equal bytes.
Result<void> writeHeightPng(const HeightImage& image, const std::filesystem::path& file);

} // namespace usar::sim
