// The text of a world's world.sdf, for world_writer.h.
#pragma once

#include <string>

#include "core/sim/world/world.h"

namespace usar::sim {

/// Maps heights to the values of a 16-bit picture: value = (height - datum) / step.
struct HeightScale {
    double datum_m = 0.0;
    double step_m = 0.0; ///< 0 if the ground needs no picture
};

/// Largest value of a 16-bit picture.
inline constexpr double highest_picture_value = 65535.0;

/// Returns the whole file. It refers to height.png if `scale` has a step, and to plants.csv if there are plants.
std::string sdfText(const World& world, const HeightScale& scale);

} // namespace usar::sim
