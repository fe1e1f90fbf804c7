// How good a scan is, against a truth that only a simulator knows.
#pragma once

#include <functional>
#include <optional>

#include "core/base/geometry.h"
#include "core/mapping/raster_export.h"

namespace usar::mission {

struct Truth {
    std::function<double(const Vec2&)> surface_m; ///< ground, crown or roof seen from above
    std::function<double(const Vec2&)> ground_m;  ///< bare terrain
};

struct Score {
    double coverage_pct = 0.0;            ///< known cells of the mission area
    std::optional<double> rmse_m;         ///< over known cells of open ground: where surface and ground agree
    std::optional<double> rmse_surface_m; ///< over all known cells, against the surface
};

Score score(const mapping::Raster& raster, const Rectangle& area_in_map, const Truth* truth);

} // namespace usar::mission
