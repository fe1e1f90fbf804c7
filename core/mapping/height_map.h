// The map that a scan leaves: sparse square tiles of height cells, growing in any direction.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/cause.h"
#include "core/base/geometry.h"

namespace usar::mapping {

/// Column (x) and row (y) of a cell or tile; negative ones are as good as positive ones.
struct GridIndex {
    std::int32_t column = 0;
    std::int32_t row = 0;
    auto operator<=>(const GridIndex&) const = default;
};

/// 64 x 64 cells, row-major from the lowest x and y. Unknown cells are NaN.
struct HeightTile {
    static constexpr std::int32_t side = 64;
    static constexpr std::size_t cell_count = std::size_t(side) * side;

    GridIndex index;                         ///< in tiles: cell (0,0) of this tile is cell index * side
    std::array<float, cell_count> height_m;  ///< the array of the thesis: a second value makes the mean with the first
    std::array<float, cell_count> preview_m; ///< what the preview shows: the newest value
    std::array<std::uint16_t, cell_count>
        hits; ///< values taken, saturating; 0 with a known height = filled between beams
    std::array<std::uint64_t, cell_count> line; ///< line number of the newest scan that wrote here (provenance)
    HeightTile();
};

struct HeightRange {
    float minimum_m = 0.0f;
    float maximum_m = 0.0f;
    bool operator==(const HeightRange&) const = default;
};

/// Rectangle of cells, `last` included.
struct CellBounds {
    GridIndex first;
    GridIndex last;
    std::int64_t columns() const { return std::int64_t(last.column) - first.column + 1; }
    std::int64_t rows() const { return std::int64_t(last.row) - first.row + 1; }
    bool operator==(const CellBounds&) const = default;
};

/// Heights above the map's datum (z up), in metres, on a grid of square cells. Cell (c, r) covers x in
/// [c, c+1) * cell_size and y likewise. Not thread-safe; owned by one session. Copies of tiles go to other threads.
class HeightMap {
public:
    explicit HeightMap(double cell_size_m);

    double cellSize_m() const { return cell_size_m_; }
    /// Points further than 2^30 cells away (and NaN) land in the outermost cells.
    GridIndex cellAt(const Vec2& point_in_map_m) const;
    Vec2 center_m(GridIndex cell) const;

    /// A measured height: preview := value; array := value, or the mean of the old and the new (thesis 4.2). What was
    /// only filled is no recorded value: the measured one replaces it. Values that are not finite are ignored.
    void write(GridIndex cell, float height_m, LineNumber line);
    /// A height made up between two measured ones: written only where nothing was measured; a second one makes the
    /// mean too.
    void fill(GridIndex cell, float height_m, LineNumber line);

    std::optional<float> height_m(GridIndex cell) const;
    std::optional<float> preview_m(GridIndex cell) const;
    int hits(GridIndex cell) const;
    LineNumber line(GridIndex cell) const;

    /// Known cells, measured and filled.
    std::size_t knownCellCount() const { return known_cells_; }
    /// Running minimum and maximum of all values taken; it only widens, and the shade follows it.
    std::optional<HeightRange> range() const { return range_; }
    std::optional<CellBounds> bounds() const; ///< of known cells, to the tile's border
    std::size_t tileCount() const { return tiles_.size(); }
    std::size_t memoryBytes() const;

    const HeightTile* tile(GridIndex tile_index) const;
    std::vector<GridIndex> tileIndices() const;
    /// Copies of the tiles written since the last call.
    std::vector<std::shared_ptr<const HeightTile>> takeChangedTiles();

private:
    /// A tile and whether it is listed in `changed_`.
    struct Slot {
        HeightTile tile;
        bool changed = false;
    };
    /// Neighbouring cells are written one after the other, so the slot of the last write is tried first.
    Slot& slotFor(GridIndex cell);
    void note(Slot& slot, std::size_t offset, float height_m, LineNumber line);

    double cell_size_m_;
    std::map<GridIndex, std::unique_ptr<Slot>> tiles_;
    std::vector<GridIndex> changed_;
    Slot* last_slot_ = nullptr;
    std::size_t known_cells_ = 0;
    std::optional<HeightRange> range_;
};

} // namespace usar::mapping
