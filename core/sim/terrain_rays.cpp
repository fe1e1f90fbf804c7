#include "core/sim/terrain_rays.h"

#include <algorithm>
#include <cmath>

namespace usar::sim {

namespace {

constexpr std::ptrdiff_t tile_cells = 16;

/// When a coordinate that moves at `speed` leaves cell `cell` of width `width`.
double leaves(double start, double speed, std::ptrdiff_t cell, std::ptrdiff_t width) {
    if (speed == 0.0)
        return no_hit_m;
    const std::ptrdiff_t edge = (speed > 0.0 ? cell + 1 : cell) * width;
    return (static_cast<double>(edge) - start) / speed;
}

std::ptrdiff_t cellAt(double coordinate, std::ptrdiff_t first, std::ptrdiff_t last) {
    return std::clamp(static_cast<std::ptrdiff_t>(std::floor(coordinate)), first, last);
}

std::ptrdiff_t signOf(double value) {
    return value > 0.0 ? 1 : -1;
}

} // namespace

/// The ray in grid coordinates (1 = one cell), parameter in metres.
struct TerrainRays::Walk {
    double x, y, z, dx, dy, dz;
    double enter = 0.0;
    double leave = no_hit_m;

    double xAt(double t) const { return x + t * dx; }
    double yAt(double t) const { return y + t * dy; }
    double zAt(double t) const { return z + t * dz; }

    void clip(double start, double speed, double low, double high) {
        if (speed == 0.0) {
            if (start < low || start > high)
                leave = -no_hit_m;
            return;
        }
        const double a = (low - start) / speed;
        const double b = (high - start) / speed;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
};

struct TerrainRays::Tile {
    std::ptrdiff_t column, row;
    double enter, leave;
};

namespace {

/// Four posts of a cell and the height of its two triangles; u, v within the cell.
struct Cell {
    double low, right, left, high;

    double maximum() const { return std::max(std::max(low, right), std::max(left, high)); }
    double height(double u, double v) const {
        return u >= v ? low + u * (right - low) + v * (high - right) : low + v * (left - low) + u * (high - left);
    }
};

/// Parameter in 0..1 where a straight line from (u0, v0, z0) to (u1, v1, z1) first dips below the cell's surface.
double dips(const Cell& cell, const Vec3& from, const Vec3& to) {
    double before = from.z() - cell.height(from.x(), from.y());
    if (before < 0.0)
        return 0.0;
    double start = 0.0;
    const double side0 = from.x() - from.y();
    const double side1 = to.x() - to.y();
    if (side0 * side1 < 0.0) {
        const double middle = side0 / (side0 - side1);
        const Vec3 at = from + middle * (to - from);
        const double gap = at.z() - (cell.low + at.x() * (cell.high - cell.low));
        if (gap < 0.0)
            return middle * before / (before - gap);
        before = gap;
        start = middle;
    }
    const double after = to.z() - cell.height(to.x(), to.y());
    return after < 0.0 ? start + (1.0 - start) * before / (before - after) : no_hit_m;
}

} // namespace

TerrainRays::TerrainRays(const Terrain& terrain) : terrain_(&terrain) {
    if (terrain.empty())
        return;
    const auto tiles = [](std::size_t posts) { return (static_cast<std::ptrdiff_t>(posts) - 2) / tile_cells + 1; };
    tile_columns_ = tiles(terrain.columns());
    const std::ptrdiff_t tile_rows = tiles(terrain.rows());
    tile_maxima_m_.assign(static_cast<std::size_t>(tile_columns_ * tile_rows), terrain.minimum_m());
    for (std::size_t row = 0; row < terrain.rows(); ++row)
        for (std::size_t column = 0; column < terrain.columns(); ++column) {
            // A post on a tile's edge belongs to the tiles on both sides.
            const auto c = static_cast<std::ptrdiff_t>(column);
            const auto r = static_cast<std::ptrdiff_t>(row);
            const float height_m = terrain.post_m(column, row);
            for (std::ptrdiff_t tr = std::max<std::ptrdiff_t>(r - 1, 0) / tile_cells;
                 tr <= std::min(r / tile_cells, tile_rows - 1); ++tr)
                for (std::ptrdiff_t tc = std::max<std::ptrdiff_t>(c - 1, 0) / tile_cells;
                     tc <= std::min(c / tile_cells, tile_columns_ - 1); ++tc) {
                    float& maximum_m = tile_maxima_m_[static_cast<std::size_t>(tr * tile_columns_ + tc)];
                    maximum_m = std::max(maximum_m, height_m);
                }
        }
}

double TerrainRays::cast(const Ray& ray, double maximum_m) const {
    if (terrain_->empty())
        return maximum_m;
    const double step_m = terrain_->step_m();
    const auto last_column = static_cast<std::ptrdiff_t>(terrain_->columns()) - 2;
    const auto last_row = static_cast<std::ptrdiff_t>(terrain_->rows()) - 2;
    Walk walk{.x = (ray.origin_m.x() - terrain_->origin_m().x()) / step_m,
              .y = (ray.origin_m.y() - terrain_->origin_m().y()) / step_m,
              .z = ray.origin_m.z(),
              .dx = ray.direction.x() / step_m,
              .dy = ray.direction.y() / step_m,
              .dz = ray.direction.z(),
              .leave = maximum_m};
    walk.clip(walk.x, walk.dx, 0.0, static_cast<double>(last_column + 1));
    walk.clip(walk.y, walk.dy, 0.0, static_cast<double>(last_row + 1));
    if (walk.leave < walk.enter)
        return maximum_m;
    const double ground_m =
        terrain_->height_m(terrain_->origin_m() + step_m * Vec2{walk.xAt(walk.enter), walk.yAt(walk.enter)});
    if (walk.zAt(walk.enter) < ground_m)
        return walk.enter;
    // One metre of slack below keeps rays that end exactly on the lowest ground.
    walk.clip(walk.z, walk.dz, terrain_->minimum_m() - 1.0, terrain_->maximum_m());

    Tile tile{.column = cellAt(walk.xAt(walk.enter), 0, last_column) / tile_cells,
              .row = cellAt(walk.yAt(walk.enter), 0, last_row) / tile_cells,
              .enter = walk.enter,
              .leave = walk.enter};
    while (tile.enter < walk.leave && tile.column >= 0 && tile.column <= last_column / tile_cells && tile.row >= 0 &&
           tile.row <= last_row / tile_cells) {
        const double next_x = leaves(walk.x, walk.dx, tile.column, tile_cells);
        const double next_y = leaves(walk.y, walk.dy, tile.row, tile_cells);
        tile.leave = std::max(tile.enter, std::min({next_x, next_y, walk.leave}));
        if (reachesTile(walk, tile)) {
            const double hit_m = crossTile(walk, tile);
            if (hit_m < no_hit_m)
                return hit_m;
        }
        (next_x < next_y ? tile.column : tile.row) += signOf(next_x < next_y ? walk.dx : walk.dy);
        tile.enter = tile.leave;
    }
    return maximum_m;
}

bool TerrainRays::reachesTile(const Walk& walk, const Tile& tile) const {
    const double lowest_m = std::min(walk.zAt(tile.enter), walk.zAt(tile.leave));
    return lowest_m <= tile_maxima_m_[static_cast<std::size_t>(tile.row * tile_columns_ + tile.column)];
}

double TerrainRays::crossTile(const Walk& walk, const Tile& tile) const {
    const auto columns = static_cast<std::ptrdiff_t>(terrain_->columns());
    const auto rows = static_cast<std::ptrdiff_t>(terrain_->rows());
    const std::ptrdiff_t first_column = tile.column * tile_cells;
    const std::ptrdiff_t first_row = tile.row * tile_cells;
    const std::ptrdiff_t last_column = std::min(first_column + tile_cells - 1, columns - 2);
    const std::ptrdiff_t last_row = std::min(first_row + tile_cells - 1, rows - 2);
    std::ptrdiff_t column = cellAt(walk.xAt(tile.enter), first_column, last_column);
    std::ptrdiff_t row = cellAt(walk.yAt(tile.enter), first_row, last_row);
    const float* posts = terrain_->heights_m().data();

    for (double t = tile.enter; t < tile.leave;) {
        const double next_x = leaves(walk.x, walk.dx, column, 1);
        const double next_y = leaves(walk.y, walk.dy, row, 1);
        const double next = std::max(t, std::min({next_x, next_y, tile.leave}));
        const float* post = posts + row * columns + column;
        const Cell cell{post[0], post[1], post[columns], post[columns + 1]};
        if (std::min(walk.zAt(t), walk.zAt(next)) <= cell.maximum()) {
            const auto x = static_cast<double>(column);
            const auto y = static_cast<double>(row);
            const double part = dips(cell, {walk.xAt(t) - x, walk.yAt(t) - y, walk.zAt(t)},
                                     {walk.xAt(next) - x, walk.yAt(next) - y, walk.zAt(next)});
            if (part <= 1.0)
                return t + part * (next - t);
        }
        (next_x < next_y ? column : row) += signOf(next_x < next_y ? walk.dx : walk.dy);
        if (column < first_column || column > last_column || row < first_row || row > last_row)
            break;
        t = next;
    }
    return no_hit_m;
}

} // namespace usar::sim
