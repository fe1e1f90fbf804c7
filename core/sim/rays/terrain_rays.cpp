#include "core/sim/rays/terrain_rays.h"

#include <algorithm>

namespace usar::sim {

namespace {

constexpr std::ptrdiff_t finest_cells = 4;
constexpr std::ptrdiff_t times_coarser = 4;
constexpr std::ptrdiff_t tile_cells = finest_cells * times_coarser;
constexpr std::size_t tile_level = 1;
constexpr double rounding_m = 1e-6;

/// The four posts of a cell, and the height of its two triangles at u, v within the cell.
struct Corners {
    double low, right, left, high;

    double maximum() const { return std::max(std::max(low, right), std::max(left, high)); }
    double height(double u, double v) const {
        return u >= v ? low + u * (right - low) + v * (high - right) : low + v * (left - low) + u * (high - left);
    }
};

/// Parameter in 0..1 at which a straight line from (u0, v0, z0) to (u1, v1, z1) first dips below the cell's surface, or
/// `no_hit_m`.
double dips(const Corners& corners, const Vec3& from, const Vec3& to) {
    double before = from.z() - corners.height(from.x(), from.y());
    if (before < 0.0)
        return 0.0;
    double start = 0.0;
    const double side0 = from.x() - from.y();
    const double side1 = to.x() - to.y();
    if (side0 * side1 < 0.0) {
        const double middle = side0 / (side0 - side1);
        const Vec3 at = from + middle * (to - from);
        const double gap = at.z() - (corners.low + at.x() * (corners.high - corners.low));
        if (gap < 0.0)
            return middle * before / (before - gap);
        before = gap;
        start = middle;
    }
    const double after = to.z() - corners.height(to.x(), to.y());
    return after < 0.0 ? start + (1.0 - start) * before / (before - after) : no_hit_m;
}

} // namespace

TerrainRays::TerrainRays(const Terrain& terrain) : terrain_(&terrain) {
    if (terrain.empty())
        return;
    levels_.push_back(finestMaxima(terrain));
    const auto longer = static_cast<std::ptrdiff_t>(std::max(terrain.columns(), terrain.rows()));
    while (levels_.size() <= tile_level || levels_.back().cells < longer)
        levels_.push_back(coarser(levels_.back()));
}

TerrainRays::Maxima TerrainRays::finestMaxima(const Terrain& terrain) {
    const auto columns = static_cast<std::ptrdiff_t>(terrain.columns());
    const auto rows = static_cast<std::ptrdiff_t>(terrain.rows());
    Maxima maxima(finest_cells, (columns - 2) / finest_cells + 1, (rows - 2) / finest_cells + 1);
    const float* posts = terrain.heights_m().data();
    for (std::ptrdiff_t row = 0; row < maxima.rows; ++row)
        for (std::ptrdiff_t column = 0; column < maxima.columns; ++column) {
            // Posts on the edge between two squares belong to both.
            const std::ptrdiff_t last_row = std::min((row + 1) * finest_cells, rows - 1);
            const std::ptrdiff_t last_column = std::min((column + 1) * finest_cells, columns - 1);
            float highest_m = terrain.minimum_m();
            for (std::ptrdiff_t r = row * finest_cells; r <= last_row; ++r)
                for (std::ptrdiff_t c = column * finest_cells; c <= last_column; ++c)
                    highest_m = std::max(highest_m, posts[r * columns + c]);
            maxima.at(column, row) = highest_m;
        }
    return maxima;
}

TerrainRays::Maxima TerrainRays::coarser(const Maxima& fine) {
    Maxima maxima(fine.cells * times_coarser, (fine.columns - 1) / times_coarser + 1,
                  (fine.rows - 1) / times_coarser + 1);
    for (std::ptrdiff_t row = 0; row < fine.rows; ++row)
        for (std::ptrdiff_t column = 0; column < fine.columns; ++column) {
            float& highest_m = maxima.at(column / times_coarser, row / times_coarser);
            highest_m = std::max(highest_m, fine.at(column, row));
        }
    return maxima;
}

bool TerrainRays::isOver(const Vec3& point_m) const {
    const Vec2 at = (point_m.head<2>() - terrain_->origin_m()) / terrain_->step_m();
    const Vec2 last(static_cast<double>(terrain_->columns()) - 1.0, static_cast<double>(terrain_->rows()) - 1.0);
    return !terrain_->empty() && (at.array() >= 0.0).all() && (at.array() <= last.array()).all() &&
           point_m.z() >= terrain_->height_m(point_m.head<2>());
}

double TerrainRays::cast(const Ray& ray, double maximum_m, bool starts_over) const {
    if (terrain_->empty())
        return maximum_m;
    GridWalk walk(ray, terrain_->origin_m(), terrain_->step_m(), no_hit_m);
    walk.clip(walk.x, 0.0, static_cast<double>(terrain_->columns() - 1));
    walk.clip(walk.y, 0.0, static_cast<double>(terrain_->rows() - 1));
    if (std::min(walk.leave, maximum_m) < walk.enter)
        return maximum_m;
    if (!starts_over) {
        const Vec3 enters_m = ray.origin_m + walk.enter * ray.direction;
        if (enters_m.z() < terrain_->height_m(enters_m.head<2>()))
            return walk.enter;
    }
    // One meter of slack below keeps rays that end exactly on the lowest ground.
    walk.clip(walk.z, static_cast<double>(terrain_->minimum_m()) - 1.0, static_cast<double>(terrain_->maximum_m()));

    double enter = walk.enter;
    const double end = std::min(walk.leave, maximum_m);
    const Maxima& tiles = levels_[tile_level];
    GridCell tile(walk, enter, tiles.columns, tiles.rows, tile_cells);
    while (enter < end && tile.isWithin(tiles.columns, tiles.rows)) {
        const GridCell here = tile;
        const double leave = std::max(enter, std::min(tile.advance(walk), end));
        const double hit_m = crossTile(walk, here, enter, leave);
        if (hit_m < no_hit_m)
            return std::min(hit_m, maximum_m);
        enter = leave;
    }
    return maximum_m;
}

double TerrainRays::castNearest(const RayBundle& bundle, double maximum_m) const {
    if (terrain_->empty())
        return maximum_m;
    const double highest_m = highestUnder_m(bundle.box(maximum_m)) + rounding_m;
    const double start_m = bundle.origin_m().z();
    const bool starts_over = isOver(bundle.origin_m());
    double nearest_m = maximum_m;
    for (const Vec3& direction : bundle.directions())
        if (std::min(start_m, start_m + nearest_m * direction.z()) <= highest_m)
            nearest_m = cast({bundle.origin_m(), direction}, nearest_m, starts_over);
    return nearest_m;
}

double TerrainRays::highestUnder_m(const Eigen::AlignedBox3d& box) const {
    constexpr double most_squares = 4.0; // Per side; more and fewer are both slower.
    const Vec2 low = (box.min().head<2>() - terrain_->origin_m()) / terrain_->step_m();
    const Vec2 high = (box.max().head<2>() - terrain_->origin_m()) / terrain_->step_m();
    const double longer = (high - low).maxCoeff();
    std::size_t level = 0;
    while (level + 1 < levels_.size() && longer > most_squares * static_cast<double>(levels_[level].cells))
        ++level;
    const Maxima& maxima = levels_[level];
    const double square = 1.0 / static_cast<double>(maxima.cells);
    const auto squareAt = [&](double cell, std::ptrdiff_t count) {
        return static_cast<std::ptrdiff_t>(std::min(std::max(0.0, cell * square), static_cast<double>(count - 1)));
    };
    const std::ptrdiff_t last_column = squareAt(high.x(), maxima.columns);
    const std::ptrdiff_t last_row = squareAt(high.y(), maxima.rows);
    double highest_m = static_cast<double>(terrain_->minimum_m());
    for (std::ptrdiff_t row = squareAt(low.y(), maxima.rows); row <= last_row; ++row)
        for (std::ptrdiff_t column = squareAt(low.x(), maxima.columns); column <= last_column; ++column)
            highest_m = std::max(highest_m, static_cast<double>(maxima.at(column, row)));
    return highest_m;
}

double TerrainRays::crossTile(const GridWalk& walk, const GridCell& tile, double enter, double leave) const {
    const double top_m = levels_[tile_level].at(tile.column, tile.row);
    if (walk.lowest_m(enter, leave) > top_m)
        return no_hit_m;
    // A falling ray need not be followed until it is down at the tile's highest post.
    double t = walk.z.speed < 0.0 ? std::max(enter, (top_m - walk.z.start) * walk.z.inverse) : enter;
    const auto columns = static_cast<std::ptrdiff_t>(terrain_->columns());
    const auto rows = static_cast<std::ptrdiff_t>(terrain_->rows());
    GridCell cell(walk, t, columns - 1, rows - 1, 1);
    const float* posts = terrain_->heights_m().data();
    while (t < leave && cell.isWithin(columns - 1, rows - 1)) {
        const auto x = static_cast<double>(cell.column);
        const auto y = static_cast<double>(cell.row);
        const float* post = posts + cell.row * columns + cell.column;
        const Corners corners{post[0], post[1], post[columns], post[columns + 1]};
        // Go to the cell's far edge, even beyond `leave`, so that the hit does not depend on how far the caller looks.
        const double next = std::max(t, std::min(cell.advance(walk), walk.leave));
        if (walk.lowest_m(t, next) <= corners.maximum()) {
            const double part = dips(corners, {walk.x.at(t) - x, walk.y.at(t) - y, walk.z.at(t)},
                                     {walk.x.at(next) - x, walk.y.at(next) - y, walk.z.at(next)});
            if (part <= 1.0)
                return t + part * (next - t);
        }
        t = next;
    }
    return no_hit_m;
}

} // namespace usar::sim
