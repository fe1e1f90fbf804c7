// The height map as a surface in levels of detail, for views in perspective.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/mapping/height_map.h"
#include "core/mapping/raster_export.h"
#include "core/mapping/shading.h"

namespace usar::mapping {

/// How the surface is colored: as the map is.
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
        std::vector<float> corners_m;      ///< (squares + 1)^2, row-major from the lowest x and y; NaN is unknown
        std::vector<std::uint32_t> colors; ///< squares^2, as 0xffRRGGBB; 0: a hole
    };
    GridIndex index; ///< in tiles
    std::array<Level, level_count> levels;
    HeightRange range; ///< It covers the corners of the finest level.
    CellBounds known;  ///< the smallest rectangle around its known cells, which are counted from the map's origin
};

/// A value that is cheap to copy: tiles are immutable and shared, so that a worker may draw a copy.
struct ReliefSurface {
    double cell_size_m = 0.25;
    ReliefStyle style{};
    std::map<GridIndex, std::shared_ptr<const ReliefTile>> tiles{}; ///< without those that have no known cell

    /// The height of the surface's nearest corner; nullopt over a hole.
    std::optional<float> height_m(const Vec2& point_in_map_m) const;
    /// Lowest and highest corner; nullopt for an empty surface.
    std::optional<HeightRange> range() const;
    // A stray scan with a garbled position can create a tile a thousand kilometers away. The next two leave out tiles
    // that are too far away from the median tile to be in one raster with it.
    /// Some of its corners, a few meters apart, which tell how far it reaches.
    std::vector<Vec3> someCorners() const;
    /// The smallest rectangle around the known cells, in meters; it is empty if there are none.
    Rectangle bounds_in_map() const;
};

/// Makes the surface over these tiles again, and over their neighbors, which share corners with them; all tiles if the
/// cell size or the style is another. Heights are those of the preview, as on the map. A tile takes about a tenth of a
/// millisecond, so this is for a worker.
void renewRelief(ReliefSurface& surface, const HeightTiles& tiles, double cell_size_m, const ReliefStyle& style,
                 std::span<const GridIndex> changed);

/// The surface over a raster. Cells are put together, two by two, until there are at most `most_cells` of them.
ReliefSurface reliefOf(const Raster& raster, const ReliefStyle& style, std::int64_t most_cells = std::int64_t(1) << 22);

} // namespace usar::mapping
