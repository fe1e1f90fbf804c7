#include "core/mapping/raster_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace usar::mapping {

namespace {

constexpr float unknown_m = std::numeric_limits<float>::quiet_NaN();

/// Where a raster lies in the raster of both: column and row of its first cell.
struct RasterPlace {
    std::int64_t column = 0;
    std::int64_t row = 0;
};

RasterPlace placeIn(const Raster& whole, const Raster& part) {
    const Vec2 offset = (part.upper_left_center_m - whole.upper_left_center_m) / whole.cell_size_m;
    return {std::llround(offset.x()), std::llround(-offset.y())};
}

float heightAt(const Raster& raster, const RasterPlace& place, std::int64_t column, std::int64_t row) {
    column -= place.column;
    row -= place.row;
    if (column < 0 || row < 0 || column >= raster.columns || row >= raster.rows)
        return unknown_m;
    return raster.heights_m[static_cast<std::size_t>(row * raster.columns + column)];
}

/// Without heights; nothing if it would be too large.
std::optional<Raster> frameOf(const Raster& first, const Raster& second) {
    Raster whole;
    whole.cell_size_m = first.cell_size_m;
    whole.upper_left_center_m = {std::min(first.upper_left_center_m.x(), second.upper_left_center_m.x()),
                                 std::max(first.upper_left_center_m.y(), second.upper_left_center_m.y())};
    for (const Raster* const one : {&first, &second}) {
        const RasterPlace place = placeIn(whole, *one);
        whole.columns = std::max(whole.columns, place.column + one->columns);
        whole.rows = std::max(whole.rows, place.row + one->rows);
    }
    const bool fits = whole.columns <= maximum_raster_side && whole.rows <= maximum_raster_side &&
                      whole.columns * whole.rows <= roomy_raster_cells;
    return fits ? std::optional(std::move(whole)) : std::nullopt;
}

} // namespace

std::optional<RasterDifference> differenceOf(const Raster& first, const Raster& second) {
    if (first.empty() || second.empty() || std::abs(first.cell_size_m - second.cell_size_m) > 1e-9 * first.cell_size_m)
        return std::nullopt;
    auto whole = frameOf(first, second);
    if (!whole)
        return std::nullopt;
    RasterDifference difference{.second_minus_first = *std::move(whole)};
    Raster& raster = difference.second_minus_first;
    const RasterPlace place_of_first = placeIn(raster, first), place_of_second = placeIn(raster, second);
    double sum_m = 0.0, sum_of_squares_m2 = 0.0;
    raster.heights_m.reserve(static_cast<std::size_t>(raster.columns * raster.rows));
    for (std::int64_t row = 0; row < raster.rows; ++row)
        for (std::int64_t column = 0; column < raster.columns; ++column) {
            const float before_m = heightAt(first, place_of_first, column, row);
            const float after_m = heightAt(second, place_of_second, column, row);
            const float change_m = after_m - before_m;
            raster.heights_m.push_back(change_m);
            difference.only_first += !std::isnan(before_m) && std::isnan(after_m);
            difference.only_second += std::isnan(before_m) && !std::isnan(after_m);
            if (std::isnan(change_m))
                continue;
            ++difference.in_both;
            sum_m += change_m;
            sum_of_squares_m2 += double(change_m) * change_m;
            difference.largest_m = std::max(difference.largest_m, std::abs(double(change_m)));
        }
    if (difference.in_both > 0) {
        difference.mean_m = sum_m / double(difference.in_both);
        difference.rms_m = std::sqrt(sum_of_squares_m2 / double(difference.in_both));
    }
    return difference;
}

} // namespace usar::mapping
