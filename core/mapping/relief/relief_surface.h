// The height map as a surface in levels of detail, for views in perspective.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/mapping/height_map.h"
#include "core/mapping/raster_export.h"
#include "core/mapping/shading.h"

namespace usar::mapping {

/// How the surface is colored: as the map is. Squares get their color as they are drawn, so another style costs
/// nothing.
struct ReliefStyle {
    HeightRange range{};
    ColorMap color_map = ColorMap::Color;
    double contour_step_m = 0.0; ///< 0: no contours
    bool operator==(const ReliefStyle&) const = default;
};

/// The surface over one tile of the map. Level n has a square over each block of 2^n x 2^n cells. A block is known if
/// at least two of the four blocks below it are, so that a narrow strip stays visible from afar; over unknown ones the
/// surface has a hole. A corner lies at the mean height of the known blocks around it, those of other tiles included:
/// both tiles at a border know the same corners there, in each level.
struct ReliefTile {
    static constexpr int level_count = 6;
    static constexpr int squaresAt(int level) { return HeightTile::side >> level; } ///< along a side
    struct Level {
        // Row-major from the lowest x and y; NaN is unknown.
        std::vector<float> corners_m;   ///< (squares + 1)^2
        std::vector<float> blocks_m;    ///< (squares + 2)^2: one of the neighbors' blocks is around the tile's own
        std::vector<std::int8_t> light; ///< squares^2, in parts of `full_light`, as lightOn() says it
    };
    static constexpr float full_light = 127.0f;
    GridIndex index; ///< in tiles
    std::array<Level, level_count> levels;
    HeightRange range; ///< It covers the corners of the finest level.
    CellBounds known;  ///< the smallest rectangle around its known cells, which are counted from the map's origin
    int known_cells = 0;

    /// The height of a block, which is the tile's own or next to one; NaN over a hole.
    float block_m(int level, int column, int row) const {
        return levels[static_cast<std::size_t>(level)]
            .blocks_m[static_cast<std::size_t>((row + 1) * (squaresAt(level) + 2) + column + 1)];
    }
};

/// The color of a square of the tile as 0xffRRGGBB; 0 for a hole.
std::uint32_t squareColor(const ReliefTile& tile, int level, int column, int row, const ReliefStyle& style);

/// A value that is cheap to copy: tiles are immutable and shared, so that a worker may draw a copy.
struct ReliefSurface {
    double cell_size_m = 0.25;
    ReliefStyle style{};
    std::map<GridIndex, std::shared_ptr<const ReliefTile>> tiles{}; ///< without those that have no known cell

    /// The height of the surface's nearest corner; nullopt over a hole.
    std::optional<float> height_m(const Vec2& point_in_map_m) const;
    /// Lowest and highest corner; nullopt for an empty surface.
    std::optional<HeightRange> range() const;
};

/// The tiles that a view of the whole surface shows. A stray scan with a garbled position can create a tile far away,
/// so a group of adjoining tiles is left out if it lies farther from the largest group than that is long, has less than
/// a quarter of its known cells, and touches none of `areas_in_map`; and so is what is too far from the median tile to
/// be in one raster with it.
std::vector<const ReliefTile*> tilesToShow(const ReliefSurface& surface, std::span<const Rectangle> areas_in_map = {});
/// Some corners of these tiles, usually a few meters apart, which tell how far they reach.
std::vector<Vec3> someCorners(std::span<const ReliefTile* const> tiles, double cell_size_m);
/// The smallest rectangle around the known cells of these tiles, in meters; it is empty if there are none.
Rectangle boundsOf(std::span<const ReliefTile* const> tiles, double cell_size_m);

/// Makes the surface over these tiles again, and over their neighbors, which share corners with them; all tiles if the
/// cell size is another. Heights are those of the preview, as on the map. A tile takes about a tenth of a millisecond,
/// so this is for a worker.
void renewRelief(ReliefSurface& surface, const HeightTiles& tiles, double cell_size_m,
                 std::span<const GridIndex> changed);

/// As many cells of a raster as a picture of usual size can show.
inline constexpr std::int64_t most_relief_cells = std::int64_t(1) << 22;
/// The surface over a raster. Cells are put together, two by two, until there are at most `most_cells` of them. A
/// request to stop leaves out what is not made yet.
ReliefSurface reliefOf(const Raster& raster, const ReliefStyle& style, std::int64_t most_cells = most_relief_cells,
                       const std::stop_token& stop = {});

} // namespace usar::mapping
