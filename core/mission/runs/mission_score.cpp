#include "core/mission/runs/mission_score.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/numbers.h"
#include "core/mapping/area_cells.h"
#include "core/mapping/coverage_path.h"

namespace usar::mission {

namespace {

constexpr double open_ground_limit_m = 0.05;

/// Accumulates a root mean square; values that are not finite are left out.
class Rms {
public:
    void add(double error_m) {
        if (!std::isfinite(error_m))
            return;
        sum_m2_ += error_m * error_m;
        ++count_;
    }
    std::optional<double> value() const {
        return count_ == 0 ? std::nullopt : std::optional(std::sqrt(sum_m2_ / double(count_)));
    }

private:
    double sum_m2_ = 0.0;
    std::int64_t count_ = 0;
};

/// Accumulates the two errors of a score.
struct Errors {
    Rms ground, surface;

    void add(const Truth& truth, const Vec2& point_m, double height_m) {
        const double surface_m = truth.surface_m(point_m);
        surface.add(height_m - surface_m);
        if (std::abs(surface_m - truth.ground_m(point_m)) < open_ground_limit_m)
            ground.add(height_m - surface_m);
    }
};

} // namespace

std::optional<FlightLimits> flightLimitsOf(const Pose& start_in_map,
                                           const std::map<std::string, agent::ParameterValue>& parameters) {
    const auto real = [&](const char* id) {
        const auto found = parameters.find(id);
        const double* const value = found == parameters.end() ? nullptr : std::get_if<double>(&found->second);
        return value ? std::optional(*value) : std::nullopt;
    };
    auto scan_altitude_m = real("scan_altitude_m");
    if (scan_altitude_m && *scan_altitude_m <= 0.0) { // It is left to the resolution.
        scan_altitude_m = real("ground_resolution_m");
        if (scan_altitude_m)
            scan_altitude_m = mapping::altitudeFor_m(*scan_altitude_m);
    }
    if (!scan_altitude_m)
        return std::nullopt;
    FlightLimits flight{.start_in_map_m = start_in_map.position_m, .scan_altitude_m = *scan_altitude_m};
    const auto climbs = parameters.find("climb_over");
    const bool stays_low = climbs != parameters.end() && climbs->second == agent::ParameterValue(false);
    flight.maximum_height_m = stays_low ? *scan_altitude_m : real("maximum_height_m").value_or(*scan_altitude_m);
    return flight;
}

Score score(const mapping::Raster& raster, const Rectangle& area_in_map, const Truth* truth) {
    Score result;
    if (raster.empty() || area_in_map.empty())
        return result;
    const double cell_m = raster.cell_size_m;
    const double lowest_y_m = raster.upper_left_center_m.y() - double(raster.rows - 1) * cell_m;
    const mapping::CellSpan columns =
        mapping::centersWithin(raster.upper_left_center_m.x(), cell_m, area_in_map.min_m.x(), area_in_map.max_m.x());
    const mapping::CellSpan rows =
        mapping::centersWithin(lowest_y_m, cell_m, area_in_map.min_m.y(), area_in_map.max_m.y());
    if (columns.count() == 0 || rows.count() == 0)
        return result;

    std::int64_t known = 0;
    Errors errors;
    for (std::int64_t up = std::max(rows.first, std::int64_t(0)); up <= std::min(rows.last, raster.rows - 1); ++up) {
        const std::int64_t start = (raster.rows - 1 - up) * raster.columns;
        for (std::int64_t column = std::max(columns.first, std::int64_t(0));
             column <= std::min(columns.last, raster.columns - 1); ++column) {
            const double height_m = double(raster.heights_m[static_cast<std::size_t>(start + column)]);
            if (std::isnan(height_m))
                continue;
            ++known;
            if (truth)
                errors.add(
                    *truth,
                    Vec2(raster.upper_left_center_m.x() + double(column) * cell_m, lowest_y_m + double(up) * cell_m),
                    height_m);
        }
    }
    result.coverage_pct = 100.0 * double(known) / (double(columns.count()) * double(rows.count()));
    result.rmse_m = errors.ground.value();
    result.rmse_surface_m = errors.surface.value();
    return result;
}

std::string unreachableNotice(const AreaReach& reach) {
    const double missing_m2 = reach.unreachable_m2();
    if (!(missing_m2 > 0.0))
        return {};
    const double missing_pct = 100.0 * missing_m2 / reach.area_m2;
    std::string text = (missing_pct < 0.1 ? "Less than 0.1" : fixed(missing_pct, missing_pct < 10.0 ? 1 : 0)) +
                       " % of the mission area (" + fixed(missing_m2, 1) + " m²) cannot be reached: ";
    bool first = true;
    for (const auto& [part_m2, place] : {std::pair(reach.outside_m2, " m² are outside the world"),
                                         {reach.shut_off_m2, " m² are inside or behind walls, or under roofs"},
                                         {reach.water_m2, " m² are water too deep to be scanned"}}) {
        if (!(part_m2 > 0.0))
            continue;
        text += (std::exchange(first, false) ? "" : ", ") + fixed(part_m2, 1) + place;
    }
    return text + ".";
}

std::optional<AreaReach> areaReach(const mapping::Raster& raster, const Rectangle& area_in_map, const Truth& truth,
                                   const FlightLimits& flight) {
    const Rectangle inside{area_in_map.min_m.cwiseMax(truth.world_in_map.min_m),
                           area_in_map.max_m.cwiseMin(truth.world_in_map.max_m)};
    if (raster.empty() || area_in_map.empty() || inside.empty() || !truth.reach)
        return std::nullopt;
    const ReachMap reach = truth.reach(flight, inside);
    if (!reach)
        return std::nullopt;
    const double cell_m = raster.cell_size_m;
    const double left_m = raster.upper_left_center_m.x();
    const double lowest_y_m = raster.upper_left_center_m.y() - double(raster.rows - 1) * cell_m;
    const mapping::CellSpan columns = mapping::centersWithin(left_m, cell_m, inside.min_m.x(), inside.max_m.x());
    const mapping::CellSpan rows = mapping::centersWithin(lowest_y_m, cell_m, inside.min_m.y(), inside.max_m.y());
    std::int64_t scanned = 0, known = 0, water = 0, shut_off = 0;
    for (std::int64_t up = rows.first; up <= rows.last; ++up)
        for (std::int64_t column = columns.first; column <= columns.last; ++column) {
            const Reach here = reach({left_m + double(column) * cell_m, lowest_y_m + double(up) * cell_m});
            water += here == Reach::OverWater;
            shut_off += here == Reach::ShutOff;
            if (here != Reach::Scanned)
                continue;
            ++scanned;
            known += column >= 0 && column < raster.columns && up >= 0 && up < raster.rows &&
                     !std::isnan(
                         raster.heights_m[static_cast<std::size_t>((raster.rows - 1 - up) * raster.columns + column)]);
        }
    if (scanned == 0)
        return std::nullopt;
    const double cell_m2 = cell_m * cell_m;
    return AreaReach{100.0 * double(known) / double(scanned), area_in_map.area_m2(),
                     area_in_map.area_m2() - inside.area_m2(), double(water) * cell_m2, double(shut_off) * cell_m2};
}

} // namespace usar::mission
