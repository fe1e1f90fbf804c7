// The text of a world's world.sdf, for the writer.
#pragma once

#include <string>

#include "core/sim/world.h"

namespace usar::sim {

/// How heights become the values of a 16-bit picture: value = (height - datum) / step.
struct HeightScale {
    double datum_m = 0.0;
    double step_m = 0.0; ///< 0 where the ground needs no picture
};

inline constexpr double highest_picture_value = 65535.0;

/// A ground with a scale refers to height.png, plants refer to plants.csv.
std::string sdfText(const World& world, const HeightScale& scale);

} // namespace usar::sim
