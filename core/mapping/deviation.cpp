#include "core/mapping/deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace usar::mapping {

namespace {

/// Standard deviations of the path by the line of a scan; NaN for a line of which nothing is known.
class SigmaOfLine {
public:
    SigmaOfLine(const ScanStore& store, const PathCorrection& correction) {
        for (const KeptScan& scan : store.scans())
            sigmas_.emplace_back(scan.line, correction.at(scan.sortie, scan.time).sigma_m);
        std::ranges::stable_sort(sigmas_, {}, &Entry::first);
    }
    Vec3 at(LineNumber line) const {
        const auto found = std::ranges::lower_bound(sigmas_, line, {}, &Entry::first);
        const bool known = found != sigmas_.end() && found->first == line;
        return known ? found->second : Vec3(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
    }

private:
    using Entry = std::pair<LineNumber, Vec3>;
    std::vector<Entry> sigmas_;
};

/// Difference of the neighbors on both sides, or of one neighbor if only that is known; 0 without any.
double slopeOf(float before_m, float here_m, float after_m, double cell_size_m) {
    const bool from = !std::isnan(before_m), to = !std::isnan(after_m);
    if (!from && !to)
        return 0.0;
    const double rise_m = double(to ? after_m : here_m) - double(from ? before_m : here_m);
    return rise_m / (cell_size_m * (from && to ? 2.0 : 1.0));
}

} // namespace

Raster deviationOf(const Raster& heights, const HeightMap& map, const ScanStore& store,
                   const PathCorrection& correction) {
    const SigmaOfLine sigmas(store, correction);
    Raster deviation = heights;
    const auto height_m = [&](std::int64_t column, std::int64_t row) {
        return column < 0 || row < 0 || column >= heights.columns || row >= heights.rows
                   ? std::numeric_limits<float>::quiet_NaN()
                   : heights.heights_m[static_cast<std::size_t>(row * heights.columns + column)];
    };
    for (std::int64_t row = 0; row < heights.rows; ++row)
        for (std::int64_t column = 0; column < heights.columns; ++column) {
            const float here_m = height_m(column, row);
            if (std::isnan(here_m))
                continue;
            const Vec2 point_m = heights.upper_left_center_m + heights.cell_size_m * Vec2(double(column), -double(row));
            const Vec3 sigma_m = sigmas.at(map.line(map.cellAt(point_m)));
            const Vec3 effect(
                slopeOf(height_m(column - 1, row), here_m, height_m(column + 1, row), heights.cell_size_m),
                slopeOf(height_m(column, row - 1), here_m, height_m(column, row + 1), heights.cell_size_m), 1.0);
            deviation.heights_m[static_cast<std::size_t>(row * heights.columns + column)] =
                static_cast<float>(sigma_m.cwiseProduct(effect).norm());
        }
    return deviation;
}

} // namespace usar::mapping
