#include "core/mission/runs/mission_score.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/mission/runs/area_cells.h"

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

Score score(const mapping::Raster& raster, const Rectangle& area_in_map, const Truth* truth) {
    Score result;
    if (raster.empty() || area_in_map.empty())
        return result;
    const double cell_m = raster.cell_size_m;
    const double lowest_y_m = raster.upper_left_center_m.y() - double(raster.rows - 1) * cell_m;
    const CellSpan columns =
        centersWithin(raster.upper_left_center_m.x(), cell_m, area_in_map.min_m.x(), area_in_map.max_m.x());
    const CellSpan rows = centersWithin(lowest_y_m, cell_m, area_in_map.min_m.y(), area_in_map.max_m.y());
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

} // namespace usar::mission
