// What stands still in a world, as seen from above.
#pragma once

#include <memory>
#include <vector>

#include "core/base/outline.h"

namespace usar {

/// A tree or bush; lengths in meters of the map frame.
struct SceneryTree {
    Vec2 center_m = Vec2::Zero();
    double trunk_radius_m = 0.0; ///< 0: a bush, or unknown
    double crown_radius_m = 0.0; ///< 0: none
    bool operator==(const SceneryTree&) const = default;
};

/// Trees and buildings of a world. Large, so it is shared and never changes.
struct Scenery {
    std::vector<SceneryTree> trees;
    std::vector<Outline> buildings;
};
using SceneryPtr = std::shared_ptr<const Scenery>;

} // namespace usar
