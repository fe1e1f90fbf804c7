#include "core/sim/terrain_rays.h"

#include <algorithm>
#include <cmath>

namespace usar::sim {

namespace {

constexpr std::ptrdiff_t tile_cells = 16;

/// Four posts of a cell and the height of its two triangles; u, v within the cell.
struct Corners {
    double low, right, left, high;

    double maximum() const { return std::max(std::max(low, right), std::max(left, high)); }
    double height(double u, double v) const {
        return u >= v ? low + u * (right - low) + v * (high - right) : low + v * (left - low) + u * (high - left);
    }
};

/// Parameter in 0..1 where a straight line from (u0, v0, z0) to (u1, v1, z1) first dips below the cell's surface.
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
    constexpr std::size_t cells = tile_cells;
    // Posts on the edge between two tiles belong to both.
    for (std::size_t row = 0; row + 1 < terrain.rows(); row += cells)
        for (std::size_t column = 0; column + 1 < terrain.columns(); column += cells) {
            float highest_m = terrain.minimum_m();
            for (std::size_t r = row; r <= std::min(row + cells, terrain.rows() - 1); ++r)
                for (std::size_t c = column; c <= std::min(column + cells, terrain.columns() - 1); ++c)
                    highest_m = std::max(highest_m, terrain.post_m(c, r));
            tile_maxima_m_.push_back(highest_m);
        }
    const auto tiles = [](std::size_t posts) { return static_cast<std::ptrdiff_t>((posts - 2) / cells + 1); };
    tile_columns_ = tiles(terrain.columns());
    tile_rows_ = tiles(terrain.rows());
}

double TerrainRays::cast(const Ray& ray, double maximum_m) const {
    if (terrain_->empty())
        return maximum_m;
    GridWalk walk(ray, terrain_->origin_m(), terrain_->step_m(), maximum_m);
    walk.clip(walk.x, 0.0, static_cast<double>(terrain_->columns() - 1));
    walk.clip(walk.y, 0.0, static_cast<double>(terrain_->rows() - 1));
    if (walk.leave < walk.enter)
        return maximum_m;
    const Vec3 enters_m = ray.origin_m + walk.enter * ray.direction;
    if (enters_m.z() < terrain_->height_m(enters_m.head<2>()))
        return walk.enter;
    // One metre of slack below keeps rays that end exactly on the lowest ground.
    walk.clip(walk.z, static_cast<double>(terrain_->minimum_m()) - 1.0, static_cast<double>(terrain_->maximum_m()));

    double enter = walk.enter;
    GridCell tile(walk, enter, tile_columns_, tile_rows_, tile_cells);
    while (enter < walk.leave && tile.isWithin(tile_columns_, tile_rows_)) {
        const GridCell here = tile;
        const double leave = std::max(enter, std::min(tile.advance(walk), walk.leave));
        const double hit_m = crossTile(walk, here, enter, leave);
        if (hit_m < no_hit_m)
            return hit_m;
        enter = leave;
    }
    return maximum_m;
}

bool TerrainRays::isClear(const Vec3& center_m, double radius_m) const {
    if (terrain_->empty())
        return true;
    const Vec2 offset_m = center_m.head<2>() - terrain_->origin_m();
    const double tile_m = static_cast<double>(tile_cells) * terrain_->step_m();
    const auto tileAt = [&](double at_m, std::ptrdiff_t count) {
        return std::clamp(static_cast<std::ptrdiff_t>(std::floor(at_m / tile_m)), std::ptrdiff_t(0), count - 1);
    };
    const double bottom_m = center_m.z() - radius_m;
    for (std::ptrdiff_t row = tileAt(offset_m.y() - radius_m, tile_rows_);
         row <= tileAt(offset_m.y() + radius_m, tile_rows_); ++row)
        for (std::ptrdiff_t column = tileAt(offset_m.x() - radius_m, tile_columns_);
             column <= tileAt(offset_m.x() + radius_m, tile_columns_); ++column)
            if (static_cast<double>(tile_maxima_m_[static_cast<std::size_t>(row * tile_columns_ + column)]) >= bottom_m)
                return false;
    return true;
}

double TerrainRays::crossTile(const GridWalk& walk, const GridCell& tile, double enter, double leave) const {
    const double top_m = tile_maxima_m_[static_cast<std::size_t>(tile.row * tile_columns_ + tile.column)];
    if (walk.lowest_m(enter, leave) > top_m)
        return no_hit_m;
    // A falling ray need not be followed before it is down at the tile's highest post.
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
        const double next = std::max(t, std::min(cell.advance(walk), leave));
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
