#include "core/mapping/relief/relief_tiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace usar::mapping {

namespace {

constexpr int relief_cells = HeightTile::side;
constexpr std::size_t corner_count = std::size_t(relief_cells + 1) * (relief_cells + 1);

/// Camera coordinates of a corner of cells as an affine function of its column and row, counted from a cell near the
/// camera, and its height: both tiles at a border find the same place for it, bit by bit.
struct GridToCamera {
    Eigen::Vector3f origin;
    Eigen::Vector3f by_column;
    Eigen::Vector3f by_row;
    Eigen::Vector3f by_height;
    GridIndex first; ///< in tiles

    GridToCamera(const ReliefProjection& projection, double cell_size_m) {
        const Vec3 eye_m = projection.eye_in_map_m();
        const double side_m = relief_cells * cell_size_m;
        const auto tileAt = [side_m](double at_m) {
            return static_cast<std::int32_t>(std::clamp(std::floor(at_m / side_m), -1e6, 1e6));
        };
        first = {tileAt(eye_m.x()), tileAt(eye_m.y())};
        const Vec3 corner_m(first.column * side_m, first.row * side_m, 0.0);
        const Vec3 at_m = projection.toCamera(corner_m);
        origin = at_m.cast<float>();
        by_column = (projection.toCamera(corner_m + Vec3(cell_size_m, 0.0, 0.0)) - at_m).cast<float>();
        by_row = (projection.toCamera(corner_m + Vec3(0.0, cell_size_m, 0.0)) - at_m).cast<float>();
        by_height = (projection.toCamera(corner_m + Vec3(0.0, 0.0, 1.0)) - at_m).cast<float>();
    }
    Eigen::Vector3f at(float column, float row, float height_m) const {
        return origin + by_column * column + by_row * row + by_height * height_m;
    }
    float columnOf(GridIndex tile) const { return static_cast<float>((tile.column - first.column) * relief_cells); }
    float rowOf(GridIndex tile) const { return static_cast<float>((tile.row - first.row) * relief_cells); }
};

/// Where a tile is seen.
struct Seen {
    const ReliefTile* tile = nullptr;
    int level = 0;
    float distance_m = 0.0f; ///< The nearest corner is so far away; 0 if the camera is above it.
    bool in_sight = false;
    bool whole = false; ///< none of it has to be cut off
};

/// The corners of one tile in one level; there is one for all tiles, so that a frame allocates nothing for a tile.
struct Corners {
    std::array<float, corner_count> heights_m;
    // Camera coordinates.
    std::array<float, corner_count> right_m;
    std::array<float, corner_count> up_m;
    std::array<float, corner_count> forward_m;
    std::array<DrawnCorner, corner_count> drawn;
    std::array<bool, corner_count> has_place; ///< on the picture's grid; the others are not in `drawn`
    /// Corners of a border that lie where another one does, as those of a coarser neighbor are farther apart.
    std::vector<std::pair<std::size_t, std::size_t>> moved{};

    Eigen::Vector3f at(std::size_t i) const { return {right_m[i], up_m[i], forward_m[i]}; }
};

class SurfaceDrawing {
public:
    SurfaceDrawing(const ReliefSurface& surface, const ReliefProjection& projection, double square_px, PictureBand band,
                   ReliefPen& pen)
        : surface_(surface)
        , projection_(projection)
        , grid_(projection, surface.cell_size_m)
        , square_px_(square_px)
        , band_(band)
        , pen_(pen) {}

    void draw() {
        std::vector<const Seen*> order;
        for (const auto& [index, tile] : surface_.tiles) {
            const Seen& seen = seen_[index] = look(*tile);
            if (seen.in_sight)
                order.push_back(&seen);
        }
        // Hidden parts of tiles that are drawn later then cost less.
        std::ranges::sort(order, {}, &Seen::distance_m);
        for (const Seen* const seen : order) {
            placeCorners(*seen);
            drawSquares(*seen);
        }
    }

private:
    Seen look(const ReliefTile& tile) const;
    int levelFor(float distance_m, const ReliefTile& tile) const;
    /// The coarsest level of those tiles around a corner of this one that share it.
    int levelAround(GridIndex index, int d_column, int d_row, int own) const;
    void placeCorners(const Seen& seen);
    void setHeights(const Seen& seen);
    void joinEdge(const Seen& seen, bool along_columns, bool far_side);
    void drawSquares(const Seen& seen);

    const ReliefSurface& surface_;
    const ReliefProjection& projection_;
    GridToCamera grid_;
    double square_px_;
    PictureBand band_;
    ReliefPen& pen_;
    std::map<GridIndex, Seen> seen_;
    std::unique_ptr<Corners> corners_ = std::make_unique<Corners>();
};

int SurfaceDrawing::levelFor(float distance_m, const ReliefTile& tile) const {
    if (square_px_ <= 0.0)
        return 0;
    const double cell_px = projection_.focal_px() * surface_.cell_size_m / std::max(double(distance_m), 0.1);
    // Along the ground, squares are seen as flat stripes, so they are larger there. They have 0.7 to 1.4 times the
    // wanted size, because each level doubles it.
    const double middle_m = (double(tile.range.minimum_m) + double(tile.range.maximum_m)) / 2.0;
    const double above_m = (projection_.eye_in_map_m().z() - middle_m) * projection_.exaggeration();
    const double flat = std::clamp(above_m / std::max(double(distance_m), 0.1), 0.15, 1.0);
    const double level = std::round(std::log2(square_px_ / (cell_px * std::sqrt(flat))));
    // NaN, which heights beyond single precision make, is the finest level.
    return level > 0.0 ? static_cast<int>(std::min(level, double(ReliefTile::level_count - 1))) : 0;
}

Seen SurfaceDrawing::look(const ReliefTile& tile) const {
    Seen seen{&tile};
    const float column = grid_.columnOf(tile.index), row = grid_.rowOf(tile.index);
    float nearest = std::numeric_limits<float>::max();
    const float focal = static_cast<float>(projection_.focal_px());
    const float half_width = static_cast<float>(projection_.width_px()) / 2.0f;
    const float half_height = static_cast<float>(projection_.height_px()) / 2.0f;
    const float left = (static_cast<float>(band_.first_px) - half_width - 1.0f) / focal;
    const float right = (static_cast<float>(band_.end_px) - half_width + 1.0f) / focal;
    const float up = (half_height + 1.0f) / focal;
    const float guard = (ReliefPen::guard_px - 2.0f * std::max(half_width, half_height)) / focal;
    int beyond_left = 0, beyond_right = 0, above = 0, below = 0, behind = 0;
    seen.whole = true;
    for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3f at = grid_.at(column + static_cast<float>(i & 1 ? relief_cells : 0),
                                            row + static_cast<float>(i & 2 ? relief_cells : 0),
                                            i & 4 ? tile.range.maximum_m : tile.range.minimum_m);
        nearest = std::min(nearest, at.z());
        beyond_left += at.x() < left * at.z();
        beyond_right += at.x() > right * at.z();
        above += at.y() > up * at.z();
        below += at.y() < -up * at.z();
        behind += at.z() < static_cast<float>(ReliefProjection::nearest_m);
        seen.whole = seen.whole && std::abs(at.x()) < guard * at.z() && std::abs(at.y()) < guard * at.z() &&
                     at.z() < ReliefPen::farthest_m;
    }
    seen.whole = seen.whole && behind == 0;
    seen.in_sight = std::max({beyond_left, beyond_right, above, below, behind}) < 8;
    seen.distance_m = std::max(nearest, 0.0f);
    seen.level = levelFor(seen.distance_m, tile);
    return seen;
}

int SurfaceDrawing::levelAround(GridIndex index, int d_column, int d_row, int own) const {
    int level = own;
    for (const GridIndex near :
         {GridIndex{index.column + d_column, index.row}, GridIndex{index.column, index.row + d_row},
          GridIndex{index.column + d_column, index.row + d_row}})
        if (const auto found = seen_.find(near); found != seen_.end())
            level = std::max(level, found->second.level);
    return level;
}

void SurfaceDrawing::setHeights(const Seen& seen) {
    const ReliefTile& tile = *seen.tile;
    const std::vector<float>& heights_m = tile.levels[static_cast<std::size_t>(seen.level)].corners_m;
    std::ranges::transform(heights_m, corners_->heights_m.begin(), [&tile](float height_m) {
        return std::isnan(height_m) ? tile.range.minimum_m : height_m; // No square has this corner.
    });
    // A tile's own corners are shared by four tiles.
    const auto across = static_cast<std::size_t>(ReliefTile::squaresAt(seen.level)) + 1;
    for (const bool right : {false, true})
        for (const bool upper : {false, true}) {
            const int level = levelAround(tile.index, right ? 1 : -1, upper ? 1 : -1, seen.level);
            const auto shared = static_cast<std::size_t>(ReliefTile::squaresAt(level)) + 1;
            const float height_m = tile.levels[static_cast<std::size_t>(level)]
                                       .corners_m[(upper ? (shared - 1) * shared : 0) + (right ? shared - 1 : 0)];
            if (!std::isnan(height_m))
                corners_->heights_m[(upper ? (across - 1) * across : 0) + (right ? across - 1 : 0)] = height_m;
        }
}

void SurfaceDrawing::joinEdge(const Seen& seen, bool along_columns, bool far_side) {
    const GridIndex own = seen.tile->index;
    const int way = far_side ? 1 : -1;
    const auto neighbor =
        seen_.find(along_columns ? GridIndex{own.column, own.row + way} : GridIndex{own.column + way, own.row});
    if (neighbor == seen_.end() || neighbor->second.level <= seen.level)
        return;
    const auto squares = static_cast<std::size_t>(ReliefTile::squaresAt(seen.level));
    const auto coarse = static_cast<std::size_t>(ReliefTile::squaresAt(neighbor->second.level));
    const auto placeOf = [=](std::size_t along, std::size_t side_squares) {
        const std::size_t across = far_side ? side_squares : 0;
        return along_columns ? across * (side_squares + 1) + along : along * (side_squares + 1) + across;
    };
    const std::size_t each = squares / coarse;
    const auto& level = seen.tile->levels[static_cast<std::size_t>(neighbor->second.level)];
    for (std::size_t along = 0; along < squares; along += each) {
        const float height_m = level.corners_m[placeOf(along / each, coarse)];
        if (std::isnan(height_m))
            continue; // The neighbor has no square here.
        if (along > 0)
            corners_->heights_m[placeOf(along, squares)] = height_m;
        for (std::size_t between = along + 1; between < along + each; ++between)
            corners_->moved.emplace_back(placeOf(between, squares), placeOf(along, squares));
    }
}

void SurfaceDrawing::placeCorners(const Seen& seen) {
    setHeights(seen);
    corners_->moved.clear();
    for (const bool along_columns : {false, true})
        for (const bool far_side : {false, true})
            joinEdge(seen, along_columns, far_side);
    const int squares = ReliefTile::squaresAt(seen.level);
    const auto step = static_cast<float>(relief_cells / squares);
    const Eigen::Vector3f by_column = grid_.by_column, by_height = grid_.by_height;
    const float first_column = grid_.columnOf(seen.tile->index);
    for (int row = 0, i = 0; row <= squares; ++row) {
        const float at_row = grid_.rowOf(seen.tile->index) + step * static_cast<float>(row);
        const Eigen::Vector3f start = grid_.origin + grid_.by_row * at_row;
        for (int column = 0; column <= squares; ++column, ++i) {
            const auto at = static_cast<std::size_t>(i);
            const float at_column = first_column + step * static_cast<float>(column);
            const float height_m = corners_->heights_m[at];
            corners_->right_m[at] = start.x() + by_column.x() * at_column + by_height.x() * height_m;
            corners_->up_m[at] = start.y() + by_column.y() * at_column + by_height.y() * height_m;
            corners_->forward_m[at] = start.z() + by_column.z() * at_column + by_height.z() * height_m;
        }
    }
    for (const auto& [corner, other] : corners_->moved) {
        corners_->right_m[corner] = corners_->right_m[other];
        corners_->up_m[corner] = corners_->up_m[other];
        corners_->forward_m[corner] = corners_->forward_m[other];
    }
    const std::size_t count = std::size_t(squares + 1) * std::size_t(squares + 1);
    for (std::size_t i = 0; i < count; ++i) {
        corners_->has_place[i] = seen.whole || pen_.hasPlace(corners_->at(i));
        if (corners_->has_place[i])
            corners_->drawn[i] = pen_.placed(corners_->right_m[i], corners_->up_m[i], corners_->forward_m[i]);
    }
}

void SurfaceDrawing::drawSquares(const Seen& seen) {
    const int squares = ReliefTile::squaresAt(seen.level);
    for (int row = 0; row < squares; ++row)
        for (int column = 0; column < squares; ++column) {
            const std::uint32_t color = squareColor(*seen.tile, seen.level, column, row, surface_.style);
            if (color == 0)
                continue;
            const auto across = static_cast<std::size_t>(squares) + 1;
            const std::size_t a = static_cast<std::size_t>(row) * across + static_cast<std::size_t>(column);
            const std::size_t b = a + 1, d = a + across, c = d + 1;
            if (corners_->has_place[a] && corners_->has_place[b] && corners_->has_place[c] && corners_->has_place[d]) {
                pen_.triangle(corners_->drawn[a], corners_->drawn[b], corners_->drawn[c], color);
                pen_.triangle(corners_->drawn[a], corners_->drawn[c], corners_->drawn[d], color);
            } else {
                pen_.clippedTriangle({corners_->at(a), corners_->at(b), corners_->at(c)}, color);
                pen_.clippedTriangle({corners_->at(a), corners_->at(c), corners_->at(d)}, color);
            }
        }
}

} // namespace

void drawSurface(const ReliefSurface& surface, const ReliefProjection& projection, double square_px, PictureBand band,
                 ReliefPen& pen) {
    SurfaceDrawing(surface, projection, square_px, band, pen).draw();
}

} // namespace usar::mapping
