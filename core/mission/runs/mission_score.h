// Quality of a scan, measured against a truth that only a simulator knows.
#pragma once

#include <functional>
#include <optional>

#include "core/base/geometry.h"
#include "core/mapping/raster_export.h"

namespace usar::mission {

/// True heights in meters above the map's datum, z up, at points in the map frame.
struct Truth {
    std::function<double(const Vec2&)> surface_m; ///< ground, crown or roof seen from above
    std::function<double(const Vec2&)> ground_m;  ///< bare terrain
};

/// Score of a scan over the cells whose centers are in the mission area.
struct Score {
    double coverage_pct = 0.0;    ///< known cells as a percentage of all cells
    std::optional<double> rmse_m; ///< over the known cells of open ground, where surface and ground agree within 0.05 m
    std::optional<double> rmse_surface_m; ///< over all known cells, against the surface
};

/// Scores `raster`. Without a truth (null), or if no cell is known, there is no rmse. Points at which the truth is not
/// finite are left out. An empty raster or area gives an empty score.
Score score(const mapping::Raster& raster, const Rectangle& area_in_map, const Truth* truth);

} // namespace usar::mission
