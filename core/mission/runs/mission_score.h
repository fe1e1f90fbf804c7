// Quality of a scan, measured against a truth that only a simulator knows.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>

#include "core/agent/parameters.h"
#include "core/base/geometry.h"
#include "core/base/reach.h"
#include "core/mapping/height_map.h"
#include "core/mapping/raster_export.h"

namespace usar::mission {

/// True heights in meters above the map's datum, z up, at points in the map frame.
struct Truth {
    std::function<double(const Vec2&)> surface_m; ///< ground, crown or roof seen from above
    std::function<double(const Vec2&)> ground_m;  ///< bare terrain
    Rectangle world_in_map{};                     ///< meters; empty: unknown
    /// Finds out what a flight can reach of an area, which may take a second; empty, or its result: it is not known.
    std::function<ReachMap(const FlightLimits& flight, const Rectangle& area_in_map)> reach{};
};

/// How a robot with these parameters flies; nullopt if it does not: its behavior has no scan altitude.
std::optional<FlightLimits> flightLimitsOf(const Pose& start_in_map,
                                           const std::map<std::string, agent::ParameterValue>& parameters);

/// Says how much of a mission area a flight could scan, and why not the rest.
struct AreaReach {
    double coverage_pct = 0.0; ///< known cells as a percentage of those that could be scanned
    double area_m2 = 0.0;      ///< the whole area
    double outside_m2 = 0.0;   ///< beyond the world's edge
    double water_m2 = 0.0;     ///< over water too deep to be scanned
    double shut_off_m2 = 0.0;  ///< behind walls, under roofs
    double unreachable_m2() const { return outside_m2 + water_m2 + shut_off_m2; }
};

/// A sentence about what cannot be reached, and why; empty if all of the area can.
std::string unreachableNotice(const AreaReach& reach);

/// Score of a scan over the cells whose centers are in the mission area.
struct Score {
    double coverage_pct = 0.0;    ///< known cells as a percentage of all cells
    std::optional<double> rmse_m; ///< over the known cells of open ground, where surface and ground agree within 0.05 m
    std::optional<double> rmse_surface_m; ///< over all known cells, against the surface
};

/// Compares the known cells of `raster` with those that the flight could have scanned; nullopt if that is not known, or
/// there are none.
std::optional<AreaReach> areaReach(const mapping::Raster& raster, const Rectangle& area_in_map, const Truth& truth,
                                   const FlightLimits& flight);

/// Scores `raster`. Without a truth (null), or if no cell is known, there is no rmse. Points at which the truth is not
/// finite are left out. An empty raster or area gives an empty score.
Score score(const mapping::Raster& raster, const Rectangle& area_in_map, const Truth* truth);

} // namespace usar::mission
