#include "core/mapping/coverage_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/numbers.h"

namespace usar::mapping {

namespace {

constexpr double maximum_lanes = 100'000;
/// With more quadrants than this (a square of 6 km at the default limit), planNearestNext would take too long.
constexpr std::size_t maximum_quadrants_sorted = 1600;

/// Number of equal pieces of `length_m` that are no longer than `limit_m`, with some tolerance: 40.0000001 / 10 gives
/// four pieces, not five.
double pieces(double length_m, double limit_m) {
    return std::max(1.0, std::ceil(length_m / limit_m - 1e-6));
}

struct Grid {
    Rectangle area;
    int columns = 1;
    int rows = 1;
    bool returns = false;   ///< to the base after each quadrant
    bool crosswise = false; ///< lanes along the shorter side

    Rectangle at(int column, int row) const {
        const Vec2 size_m(area.width_m() / columns, area.height_m() / rows);
        const Vec2 low_m = area.min_m + Vec2(size_m.x() * column, size_m.y() * row);
        return {low_m, low_m + size_m};
    }
};

double distanceToCorner(const Rectangle& quadrant, const Vec2& from_m) {
    return ((from_m - quadrant.center_m()).cwiseAbs() - (quadrant.max_m - quadrant.min_m) / 2.0).norm();
}

/// Adds the lanes of one quadrant, beginning at the corner nearest to `position_m`, and sets `position_m` to the end of
/// the last lane. `crosswise`: they run along the shorter side.
void addLanes(CoveragePlan& plan, const Rectangle& quadrant, double spacing_m, bool crosswise, Vec2& position_m) {
    const int along = (quadrant.width_m() >= quadrant.height_m()) != crosswise ? 0 : 1;
    const int across = 1 - along;
    const Vec2 size_m = quadrant.max_m - quadrant.min_m;
    const int count = static_cast<int>(pieces(size_m[across], spacing_m));
    const Vec2 center_m = quadrant.center_m();
    bool forward = position_m[along] <= center_m[along];
    const bool upward = position_m[across] <= center_m[across];
    for (int i = 0; i < count; ++i, forward = !forward) {
        const double part = (upward ? i + 0.5 : count - i - 0.5) / count;
        Lane lane;
        lane.quadrant = lane.sortie = static_cast<int>(plan.quadrants.size());
        lane.start_m[across] = lane.end_m[across] = quadrant.min_m[across] + part * size_m[across];
        lane.start_m[along] = forward ? quadrant.min_m[along] : quadrant.max_m[along];
        lane.end_m[along] = forward ? quadrant.max_m[along] : quadrant.min_m[along];
        plan.lane_length_m += size_m[along];
        plan.transit_length_m += (lane.start_m - position_m).norm();
        position_m = lane.end_m;
        plan.lanes.push_back(lane);
    }
    plan.quadrants.push_back(quadrant);
}

void returnTo(const Vec2& base_m, CoveragePlan& plan, Vec2& position_m) {
    plan.transit_length_m += (base_m - position_m).norm();
    position_m = base_m;
}

/// Visits the quadrants back and forth. The three bits of `variant` select rows or columns and the first corner.
CoveragePlan planToAndFro(const Grid& grid, const Vec2& base_m, double spacing_m, unsigned variant) {
    const bool by_rows = (variant & 1) != 0;
    const bool outer_down = (variant & 2) != 0;
    bool inner_down = (variant & 4) != 0;
    const int outer_count = by_rows ? grid.rows : grid.columns;
    const int inner_count = by_rows ? grid.columns : grid.rows;
    CoveragePlan plan;
    Vec2 position_m = base_m;
    for (int i = 0; i < outer_count; ++i, inner_down = !inner_down) {
        const int outer = outer_down ? outer_count - 1 - i : i;
        for (int j = 0; j < inner_count; ++j) {
            const int inner = inner_down ? inner_count - 1 - j : j;
            addLanes(plan, by_rows ? grid.at(inner, outer) : grid.at(outer, inner), spacing_m, grid.crosswise,
                     position_m);
            if (grid.returns)
                returnTo(base_m, plan, position_m);
        }
    }
    returnTo(base_m, plan, position_m);
    return plan;
}

CoveragePlan planNearestNext(const Grid& grid, const Vec2& base_m, double spacing_m) {
    std::vector<Rectangle> open;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            open.push_back(grid.at(column, row));
    CoveragePlan plan;
    Vec2 position_m = base_m;
    while (!open.empty()) {
        const auto nearest = std::ranges::min_element(
            open, {}, [&](const Rectangle& quadrant) { return distanceToCorner(quadrant, position_m); });
        addLanes(plan, *nearest, spacing_m, grid.crosswise, position_m);
        open.erase(nearest);
        if (grid.returns)
            returnTo(base_m, plan, position_m);
    }
    returnTo(base_m, plan, position_m);
    return plan;
}

Result<Grid> gridFor(const Rectangle& area, const Vec2& base_m, const CoverageOptions& options) {
    const std::string where = "mission area";
    if (!area.min_m.allFinite() || !area.max_m.allFinite() || area.empty())
        return failure("the area has no size", where, "give it a width and a height above zero");
    if (!base_m.allFinite())
        return failure("the base is nowhere", where, "wait until the robot knows its place");
    if (!(options.lane_spacing_m > 0.0) || !std::isfinite(options.lane_spacing_m))
        return failure("the lane spacing is not above zero", where, "10 m suits a scan altitude of 6 m");
    if (!(options.quadrant_limit_m > 0.0))
        return failure("the quadrant limit is not above zero", where, "150 m is the usual one");
    const double columns = pieces(area.width_m(), options.quadrant_limit_m);
    const double rows = pieces(area.height_m(), options.quadrant_limit_m);
    const double shorter_m = std::min(area.width_m() / columns, area.height_m() / rows);
    if (columns * rows * pieces(shorter_m, options.lane_spacing_m) > maximum_lanes)
        return failure("the area needs more than 100000 lanes", where,
                       "make the area smaller or the lane spacing wider than " + fixed(options.lane_spacing_m, 2) +
                           " m");
    return Grid{area, static_cast<int>(columns), static_cast<int>(rows), options.returns, options.crosswise};
}

} // namespace

double altitudeFor_m(double ground_resolution_m) {
    return std::clamp(16.0 * ground_resolution_m, 2.0, 10.0);
}

Result<CoveragePlan> planCoverage(const Rectangle& area_in_map, const Vec2& base_in_map_m,
                                  const CoverageOptions& options) {
    const Result<Grid> grid = gridFor(area_in_map, base_in_map_m, options);
    if (!grid)
        return tl::unexpected(grid.error());
    const double spacing_m = options.lane_spacing_m;
    const std::size_t quadrants = std::size_t(grid->columns) * std::size_t(grid->rows);
    CoveragePlan best = quadrants <= maximum_quadrants_sorted ? planNearestNext(*grid, base_in_map_m, spacing_m)
                                                              : planToAndFro(*grid, base_in_map_m, spacing_m, 0);
    for (unsigned variant = 0; quadrants > 1 && variant < 8; ++variant) {
        CoveragePlan other = planToAndFro(*grid, base_in_map_m, spacing_m, variant);
        if (other.transit_length_m < best.transit_length_m)
            best = std::move(other);
    }
    return best;
}

} // namespace usar::mapping
