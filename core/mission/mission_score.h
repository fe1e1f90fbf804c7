// How good a scan is, against a truth that only a simulator knows.
#pragma once

#include <functional>
#include <optional>

#include "core/base/geometry.h"
#include "core/mapping/raster_export.h"

namespace usar::mission {

/// Heights in metres over the map's datum, z up, at points of the map frame.
struct Truth {
    std::function<double(const Vec2&)> surface_m; ///< ground, crown or roof seen from above
    std::function<double(const Vec2&)> ground_m;  ///< bare terrain
};

/// All figures are about the cells whose centers lie in the mission area.
struct Score {
    double coverage_pct = 0.0;            ///< known cells of all cells
    std::optional<double> rmse_m;         ///< over known cells of open ground: surface and ground agree within 0.05 m
    std::optional<double> rmse_surface_m; ///< over all known cells, against the surface
};

/// Without a truth, or where no cell is known, there is no rmse. Points where the truth is not finite are left out.
Score score(const mapping::Raster& raster, const Rectangle& area_in_map, const Truth* truth);

} // namespace usar::mission
