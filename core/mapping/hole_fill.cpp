#include "core/mapping/hole_fill.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace usar::mapping {

namespace {

/// Heights that are farther from the middle one are on another floor.
constexpr float floor_gap_m = 0.5f;
constexpr double rounding = 1e-9;

struct Cell {
    std::int64_t column = 0;
    std::int64_t row = 0;
};

/// The holes of a raster.
class Holes {
public:
    Holes(const Raster& raster, double limit_m2)
        : raster_(raster)
        , met_(raster.heights_m.size(), false)
        , limit_cells_(limit_m2 / (raster.cell_size_m * raster.cell_size_m) * (1.0 - rounding)) {}

    /// Calls `take` with the cells of each hole.
    template <class Take>
    void each(Take&& take) {
        for (std::int64_t row = 0; row < raster_.rows; ++row)
            for (std::int64_t column = 0; column < raster_.columns; ++column)
                if (isUnmet({column, row}) && gather({column, row}))
                    take(std::as_const(cells_));
    }

    std::size_t indexOf(const Cell& cell) const {
        return static_cast<std::size_t>(cell.row * raster_.columns + cell.column);
    }
    bool isInside(const Cell& cell) const {
        return cell.column >= 0 && cell.row >= 0 && cell.column < raster_.columns && cell.row < raster_.rows;
    }
    bool isUnknown(const Cell& cell) const { return std::isnan(raster_.heights_m[indexOf(cell)]); }

private:
    bool isUnmet(const Cell& cell) const { return isUnknown(cell) && !met_[indexOf(cell)]; }

    /// Gathers the unknown cells that hang together with this one. Returns whether they are a hole.
    bool gather(const Cell& first) {
        cells_.assign(1, first);
        met_[indexOf(first)] = true;
        bool enclosed = true;
        for (std::size_t next = 0; next < cells_.size(); ++next)
            for (std::int64_t down = -1; down <= 1; ++down)
                for (std::int64_t right = -1; right <= 1; ++right) {
                    const Cell near{cells_[next].column + right, cells_[next].row + down};
                    if (!isInside(near)) {
                        enclosed = false;
                    } else if (isUnmet(near)) {
                        met_[indexOf(near)] = true;
                        cells_.push_back(near);
                    }
                }
        return enclosed && double(cells_.size()) < limit_cells_;
    }

    const Raster& raster_;
    std::vector<bool> met_;
    double limit_cells_;
    std::vector<Cell> cells_;
};

/// The heights around a hole.
class Rim {
public:
    Rim(const std::vector<Cell>& hole, const Raster& raster, const Holes& holes) {
        for (const Cell& cell : hole)
            for (std::int64_t down = -1; down <= 1; ++down)
                for (std::int64_t right = -1; right <= 1; ++right)
                    if (const Cell near{cell.column + right, cell.row + down}; !holes.isUnknown(near))
                        cells_.push_back({near, raster.heights_m[holes.indexOf(near)]});
        std::ranges::sort(cells_, {},
                          [&](const Known& known) { return std::pair(known.height_m, holes.indexOf(known.at)); });
        const auto twice = std::ranges::unique(cells_, {}, [&](const Known& known) { return holes.indexOf(known.at); });
        cells_.erase(twice.begin(), twice.end());
    }

    /// The mean height of the floor on which the weighted median is.
    float heightAt(const Cell& cell) const {
        double weights = 0.0;
        for (const Known& known : cells_)
            weights += weightOf(known, cell);
        float middle_m = cells_.back().height_m;
        double below = 0.0;
        for (const Known& known : cells_) { // They are sorted by height.
            below += weightOf(known, cell);
            if (below < weights / 2.0)
                continue;
            middle_m = known.height_m;
            break;
        }
        double sum_m = 0.0, counted = 0.0;
        for (const Known& known : cells_) {
            if (std::abs(known.height_m - middle_m) > floor_gap_m)
                continue;
            sum_m += weightOf(known, cell) * double(known.height_m);
            counted += weightOf(known, cell);
        }
        return static_cast<float>(sum_m / counted);
    }

private:
    struct Known {
        Cell at;
        float height_m = 0.0f;
    };
    static double weightOf(const Known& known, const Cell& cell) {
        const auto right = double(known.at.column - cell.column), down = double(known.at.row - cell.row);
        return 1.0 / (right * right + down * down);
    }

    std::vector<Known> cells_;
};

} // namespace

FilledRaster withHolesFilled(const Raster& raster, double limit_m2) {
    FilledRaster filled{raster, raster, 0};
    for (float& mark : filled.mask.heights_m)
        mark = std::isnan(mark) ? mark : 0.0f;
    Holes holes(raster, limit_m2);
    holes.each([&](const std::vector<Cell>& hole) {
        const Rim rim(hole, raster, holes);
        for (const Cell& cell : hole) {
            filled.heights.heights_m[holes.indexOf(cell)] = rim.heightAt(cell);
            filled.mask.heights_m[holes.indexOf(cell)] = 1.0f;
        }
        filled.filled_cells += hole.size();
    });
    return filled;
}

double holes_m2(const Raster& raster, double limit_m2) {
    std::size_t cells = 0;
    Holes(raster, limit_m2).each([&cells](const std::vector<Cell>& hole) { cells += hole.size(); });
    return double(cells) * raster.cell_size_m * raster.cell_size_m;
}

} // namespace usar::mapping
