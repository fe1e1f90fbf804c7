// How a person wants to see heights: as colors on the map, in its legend and in exported pictures.
#pragma once

#include <optional>

#include "core/mapping/shading.h"

namespace usar::mapping {

struct HeightLook {
    ColorMap color_map = ColorMap::Color;
    std::optional<HeightRange> fixed_range{}; ///< nullopt: the range follows the scan
    bool trimmed = false;                     ///< a range that follows the scan is HeightHistogram::trimmed
    bool operator==(const HeightLook&) const = default;
};

} // namespace usar::mapping
