// The map made from scans: sparse square tiles of height cells, which can grow in any direction.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/cause.h"
#include "core/base/geometry.h"

namespace usar::mapping {

/// Column (x) and row (y) of a cell or tile; both may be negative.
struct GridIndex {
    std::int32_t column = 0;
    std::int32_t row = 0;
    auto operator<=>(const GridIndex&) const = default;
};

/// 64 x 64 cells, row-major from the lowest x and y. Heights of unknown cells are NaN.
struct HeightTile {
    static constexpr std::int32_t side = 64;
    static constexpr std::size_t cell_count = std::size_t(side) * side;

    GridIndex index;                         ///< in tiles: cell (0,0) of this tile is cell index * side of the map
    std::array<float, cell_count> height_m;  ///< the array of the thesis: averages repeated values
    std::array<float, cell_count> preview_m; ///< the newest value, shown by the preview
    std::array<std::uint16_t, cell_count>
        hits; ///< number of measured values, saturating; 0 with a known height: filled between beams
    std::array<std::uint64_t, cell_count> line; ///< line number of the newest scan that wrote here (provenance)
    /// A tile of unknown cells.
    HeightTile();
};

/// Lowest and highest height.
struct HeightRange {
    float minimum_m = 0.0f;
    float maximum_m = 0.0f;
    bool operator==(const HeightRange&) const = default;

    /// Extends `range`, which may be nullopt, so that it includes the height.
    static void include(std::optional<HeightRange>& range, float height_m);
    /// The range of these heights without NaN; nullopt if there are no others.
    static std::optional<HeightRange> of(std::span<const float> heights_m);
};

/// A rectangle of cells that includes `last`.
struct CellBounds {
    GridIndex first;
    GridIndex last;
    std::int64_t columns() const { return std::int64_t(last.column) - first.column + 1; }
    std::int64_t rows() const { return std::int64_t(last.row) - first.row + 1; }
    /// Extends `bounds`, which may be nullopt, so that they include the cell.
    static void include(std::optional<CellBounds>& bounds, GridIndex cell);
    bool operator==(const CellBounds&) const = default;
};

/// Heights above the map's datum (z up), in meters, on a grid of square cells. Cell (c, r) covers x in [c, c+1) *
/// cell_size, and y likewise with r. Not thread-safe: each map is owned by one session, and other threads get copies of
/// tiles.
class HeightMap {
public:
    /// `cell_size_m` is positive and finite.
    explicit HeightMap(double cell_size_m);

    double cellSize_m() const { return cell_size_m_; }
    /// Points farther than 2^30 cells from the origin, and NaN, map to the outermost cells.
    GridIndex cellAt(const Vec2& point_in_map_m) const;
    Vec2 center_m(GridIndex cell) const;

    /// Records a measured height. The preview takes the value; the array takes the value, or the mean of the old and
    /// the new one (thesis 4.2). A height that was only filled in is replaced. Ignores values that are not finite.
    void write(GridIndex cell, float height_m, LineNumber line) { record(cell, height_m, line, true); }
    /// Records a height interpolated between measured ones, unless the cell has a measured height. Also takes the mean
    /// of the old and the new value. Ignores values that are not finite.
    void fill(GridIndex cell, float height_m, LineNumber line) { record(cell, height_m, line, false); }

    /// Replaces the height of a known cell; others stay unknown. Ignores values that are not finite.
    void settle(GridIndex cell, float height_m);

    /// Makes sure that there is a tile, which counts as written: so that whoever has a tile of an earlier map learns
    /// that nothing is known there now.
    void addTile(GridIndex tile_index);

    /// Values of a cell as in HeightTile; nullopt or 0 if the cell is unknown.
    std::optional<float> height_m(GridIndex cell) const;
    std::optional<float> preview_m(GridIndex cell) const;
    int hits(GridIndex cell) const;
    LineNumber line(GridIndex cell) const;

    /// Number of known cells, measured or filled.
    std::size_t knownCellCount() const { return known_cells_; }
    /// Lowest and highest value in the array now, as in the rasters; nullopt for an empty map. Looks again at the tiles
    /// written since the last call.
    std::optional<HeightRange> range() const;
    std::optional<CellBounds> bounds() const; ///< cells of all tiles; nullopt for an empty map
    std::size_t tileCount() const { return tiles_.size(); }
    std::size_t memoryBytes() const;

    /// Returns nullptr if there is no such tile. The tile exists as long as the map.
    const HeightTile* tile(GridIndex tile_index) const;
    std::vector<GridIndex> tileIndices() const;
    /// Returns copies of the tiles written since the last call.
    std::vector<std::shared_ptr<const HeightTile>> takeChangedTiles();

private:
    struct Slot {
        HeightTile tile;
        bool changed = false;             ///< it is listed in `changed_`
        std::optional<HeightRange> range; ///< range of the tile when it was last looked at
        bool range_old = false;           ///< the tile was written since
    };
    /// Finds or makes the slot. Tries the slot of the last write first, because neighboring cells are written in
    /// sequence.
    Slot& slotFor(GridIndex cell);
    void noteChange(Slot& slot);
    void record(GridIndex cell, float height_m, LineNumber line, bool measured);

    double cell_size_m_;
    std::map<GridIndex, std::unique_ptr<Slot>> tiles_;
    std::vector<GridIndex> changed_;
    Slot* last_slot_ = nullptr;
    std::size_t known_cells_ = 0;
};

/// Tiles by their index, as whoever collects them keeps them.
using HeightTiles = std::map<GridIndex, std::shared_ptr<const HeightTile>>;

/// Data of one cell.
struct HeightProbe {
    float height_m = 0.0f; ///< value of the height array: the mean of the measurements
    int hits = 0;          ///< number of measurements; 0: interpolated between two beams
    LineNumber line{};     ///< the newest scan that wrote it; 0: unknown, as where several robots know a fused cell
};

/// Data of the cell at this point of the map frame, looked up in tiles that a height map has handed out; nullopt if its
/// height is unknown. `cell_size_m` is the side of the tiles' cells.
std::optional<HeightProbe> probeHeight(const HeightTiles& tiles, double cell_size_m, const Vec2& point_in_map_m);

/// The range of the known heights in all cells that `area_in_map` touches; nullopt if there are none.
std::optional<HeightRange> rangeWithin(const HeightTiles& tiles, double cell_size_m, const Rectangle& area_in_map);

} // namespace usar::mapping
