// A ray's way over a grid of square cells: its coordinates at any time, the next cell on its way, and a walk over
// buckets.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/sim/rays/ray_shapes.h"

namespace usar::sim {

/// One coordinate of a point that moves along a ray at constant speed. Time is the distance along the ray in meters;
/// the coordinate's unit is the caller's: cells for x and y, meters for z.
struct GridAxis {
    GridAxis(double from, double per_m)
        : start(from)
        , speed(std::abs(per_m) > 1e-300 ? per_m : 0.0)
        , inverse(speed != 0.0 ? 1.0 / speed : 0.0)
        , forward(speed > 0.0 ? 1 : 0) {}

    double at(double t) const { return start + t * speed; }
    /// Time at which the point leaves cell `cell`, where a cell is `width` units wide; `no_hit_m` if the coordinate is
    /// constant.
    double leaves(std::ptrdiff_t cell, std::ptrdiff_t width) const {
        return speed != 0.0 ? (static_cast<double>((cell + forward) * width) - start) * inverse : no_hit_m;
    }
    /// The cell at time t, clamped to 0..`last`.
    std::ptrdiff_t cellAt(double t, std::ptrdiff_t last) const {
        return static_cast<std::ptrdiff_t>(std::min(std::max(0.0, at(t)), static_cast<double>(last)));
    }

    double start, speed, inverse;
    std::ptrdiff_t forward; ///< 1 toward higher cells, 0 toward lower ones
};

/// A ray over a grid and the part of it, `enter` to `leave`, that is still of interest.
struct GridWalk {
    GridWalk(const Ray& ray, const Vec2& grid_origin_m, double cell_m, double maximum_m)
        : x((ray.origin_m.x() - grid_origin_m.x()) / cell_m, ray.direction.x() / cell_m)
        , y((ray.origin_m.y() - grid_origin_m.y()) / cell_m, ray.direction.y() / cell_m)
        , z(ray.origin_m.z(), ray.direction.z())
        , leave(maximum_m) {}

    /// Keeps the part in which one coordinate is within the limits; nothing is left once `leave` < `enter`.
    void clip(const GridAxis& axis, double low, double high) {
        if (axis.speed == 0.0) {
            if (axis.start < low || axis.start > high)
                leave = -no_hit_m;
            return;
        }
        const double a = (low - axis.start) * axis.inverse;
        const double b = (high - axis.start) * axis.inverse;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }

    /// Lowest height of the ray between two times.
    double lowest_m(double from, double to) const { return std::min(z.at(from), z.at(to)); }

    GridAxis x, y, z;
    double enter = 0.0;
    double leave;
};

/// The cell under a ray at a given time, `width` grid units wide.
struct GridCell {
    GridCell(const GridWalk& walk, double t, std::ptrdiff_t columns, std::ptrdiff_t rows, std::ptrdiff_t unit_width)
        : column(walk.x.cellAt(t, columns * unit_width - 1) / unit_width)
        , row(walk.y.cellAt(t, rows * unit_width - 1) / unit_width)
        , width(unit_width) {}

    /// Moves to the next cell and returns the time at which the ray enters it.
    double advance(const GridWalk& walk) {
        const double next_x = walk.x.leaves(column, width);
        const double next_y = walk.y.leaves(row, width);
        if (next_x < next_y) {
            column += 2 * walk.x.forward - 1;
            return next_x;
        }
        row += 2 * walk.y.forward - 1;
        return next_y;
    }
    bool isWithin(std::ptrdiff_t columns, std::ptrdiff_t rows) const {
        return column >= 0 && column < columns && row >= 0 && row < rows;
    }

    std::ptrdiff_t column, row, width;
};

/// Square buckets, row by row, over a part of the map.
struct BucketGrid {
    /// Columns and rows of buckets, both ends included.
    struct Range {
        std::ptrdiff_t first_column, last_column, first_row, last_row;
        std::ptrdiff_t buckets() const { return (last_column - first_column + 1) * (last_row - first_row + 1); }
    };

    std::size_t buckets() const { return static_cast<std::size_t>(columns * rows); }

    /// The buckets under a rectangle; its parts outside of the grid count as those on the border.
    Range under(const Vec2& low_m, const Vec2& high_m) const {
        const auto bucket = [&](double at_m, double from_m, std::ptrdiff_t count) {
            const double last = static_cast<double>(count - 1);
            return static_cast<std::ptrdiff_t>(std::min(std::max(0.0, (at_m - from_m) / bucket_m), last));
        };
        return {bucket(low_m.x(), origin_m.x(), columns), bucket(high_m.x(), origin_m.x(), columns),
                bucket(low_m.y(), origin_m.y(), rows), bucket(high_m.y(), origin_m.y(), rows)};
    }

    /// Calls `take(bucket)` for the range's buckets until one call returns true; then returns true.
    template <class Take>
    bool anyIn(const Range& range, Take take) const {
        for (std::ptrdiff_t row = range.first_row; row <= range.last_row; ++row)
            for (std::ptrdiff_t column = range.first_column; column <= range.last_column; ++column)
                if (take(static_cast<std::size_t>(row * columns + column)))
                    return true;
        return false;
    }

    /// Calls `take(bucket, lowest_m, nearest_m)` for each bucket on the ray's way between two heights, with the ray's
    /// lowest height over the bucket. `take` returns the new `nearest_m`, at which the walk ends; the last one is the
    /// result.
    template <class Take>
    double along(const Ray& ray, double maximum_m, double low_z_m, double high_z_m, Take take) const {
        GridWalk walk(ray, origin_m, bucket_m, maximum_m);
        walk.clip(walk.x, 0.0, static_cast<double>(columns));
        walk.clip(walk.y, 0.0, static_cast<double>(rows));
        walk.clip(walk.z, low_z_m, high_z_m);
        if (walk.leave < walk.enter)
            return maximum_m;
        double nearest_m = maximum_m;
        double enter = walk.enter;
        GridCell cell(walk, enter, columns, rows, 1);
        while (enter <= std::min(walk.leave, nearest_m) && cell.isWithin(columns, rows)) {
            const auto bucket = static_cast<std::size_t>(cell.row * columns + cell.column);
            const double next = std::max(enter, cell.advance(walk));
            nearest_m = take(bucket, walk.lowest_m(enter, std::min(next, walk.leave)), nearest_m);
            enter = next;
        }
        return nearest_m;
    }

    Vec2 origin_m = Vec2::Zero(); ///< corner with the lowest x and y
    double bucket_m = 1.0;        ///< width of a bucket
    std::ptrdiff_t columns = 0;
    std::ptrdiff_t rows = 0;
};

} // namespace usar::sim
