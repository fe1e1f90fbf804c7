#include "core/mapping/height_fusion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace usar::mapping {

namespace {

constexpr std::int32_t side_cells = HeightTile::side;
/// Tiles farther away come from garbled positions; HeightMap has none beyond 2^30 cells either.
constexpr double farthest_tile = double(1 << 30) / side_cells;

std::int32_t clamped(double tile) {
    return static_cast<std::int32_t>(std::clamp(tile, -farthest_tile, farthest_tile));
}

/// Looks up the cells of one robot for the cells of one fused tile.
class CellSource {
public:
    CellSource(const HeightTiles& tiles, double cell_size_m, GridIndex fused, double fused_cell_size_m)
        : tiles_(tiles)
        , fused_(fused)
        , scale_(fused_cell_size_m / cell_size_m)
        , same_grid_(cell_size_m == fused_cell_size_m) {
        if (same_grid_)
            look(fused);
    }

    /// Finds the tile and the cell in it that cover the center of a cell of the fused tile; nullptr: none.
    const HeightTile* find(std::size_t offset, std::size_t& found_offset) {
        found_offset = offset;
        if (same_grid_)
            return tile_;
        const auto column = cellAt(fused_.column, static_cast<std::int32_t>(offset) % side_cells);
        const auto row = cellAt(fused_.row, static_cast<std::int32_t>(offset) / side_cells);
        const GridIndex index{clamped(std::floor(column / side_cells)), clamped(std::floor(row / side_cells))};
        if (!looked_ || index != index_)
            look(index);
        found_offset = static_cast<std::size_t>((row - double(index.row) * side_cells) * side_cells + column -
                                                double(index.column) * side_cells);
        return found_offset < HeightTile::cell_count ? tile_ : nullptr;
    }
    /// True if no cell can be found.
    bool absent() const { return same_grid_ && !tile_; }
    /// The tile that stands for all cells, if the grids are the same.
    bool sameGrid() const { return same_grid_; }

private:
    /// The robot's column or row below the center of that of the fused tile.
    double cellAt(std::int32_t fused_tile, std::int32_t cell) const {
        return std::floor((double(fused_tile) * side_cells + cell + 0.5) * scale_);
    }
    void look(GridIndex index) {
        const auto found = tiles_.find(index);
        tile_ = found == tiles_.end() ? nullptr : found->second.get();
        index_ = index;
        looked_ = true;
    }

    const HeightTiles& tiles_;
    GridIndex fused_;
    double scale_;
    bool same_grid_;
    const HeightTile* tile_ = nullptr;
    GridIndex index_;
    bool looked_ = false;
};

/// Collects the values of one cell.
class CellMean {
public:
    void add(const HeightTile& tile, std::size_t offset) {
        if (std::isnan(tile.height_m[offset]))
            return;
        const bool measured = tile.hits[offset] > 0;
        if (measured && !measured_)
            *this = {};
        if (measured_ && !measured)
            return;
        measured_ = measured;
        height_m_ += double(tile.height_m[offset]);
        preview_m_ += double(tile.preview_m[offset]);
        hits_ += tile.hits[offset];
        line_ = ++count_ == 1 ? tile.line[offset] : 0;
    }
    void putInto(HeightTile& tile, std::size_t offset) const {
        if (count_ == 0)
            return;
        tile.height_m[offset] = static_cast<float>(height_m_ / count_);
        tile.preview_m[offset] = static_cast<float>(preview_m_ / count_);
        constexpr std::uint32_t most = std::numeric_limits<std::uint16_t>::max();
        tile.hits[offset] = static_cast<std::uint16_t>(std::min(hits_, most));
        tile.line[offset] = line_;
    }

private:
    bool measured_ = false;
    int count_ = 0;
    double height_m_ = 0.0;
    double preview_m_ = 0.0;
    std::uint32_t hits_ = 0;
    std::uint64_t line_ = 0;
};

} // namespace

void HeightFusion::take(ConnectionId robot, double cell_size_m,
                        const std::vector<std::shared_ptr<const HeightTile>>& tiles, bool from_scratch) {
    if (const auto known = sources_.find(robot);
        known != sources_.end() && (from_scratch || known->second.cell_size_m != cell_size_m))
        remove(robot);
    if (tiles.empty())
        return;
    Source& source = sources_[robot];
    source.cell_size_m = cell_size_m;
    chooseGrid();
    for (const auto& tile : tiles) {
        source.tiles[tile->index] = tile;
        touch(tile->index, cell_size_m);
    }
}

void HeightFusion::remove(ConnectionId robot) {
    const auto removed = sources_.extract(robot);
    if (removed.empty())
        return;
    touchAll(removed.mapped());
    from_scratch_ = true;
    chooseGrid();
}

void HeightFusion::touch(GridIndex tile, double cell_size_m) {
    if (cell_size_m == cell_size_m_) {
        dirty_.insert(tile);
        return;
    }
    // The last cell may belong to the next tile by a rounding error, which costs no more than fusing that one, too.
    const double scale = cell_size_m / cell_size_m_;
    const auto first = [scale](std::int32_t index) { return clamped(std::floor(index * scale)); };
    const auto last = [scale](std::int32_t index) { return clamped(std::floor((double(index) + 1.0) * scale)); };
    for (std::int32_t row = first(tile.row); row <= last(tile.row); ++row)
        for (std::int32_t column = first(tile.column); column <= last(tile.column); ++column)
            dirty_.insert({column, row});
}

void HeightFusion::touchAll(const Source& source) {
    for (const auto& [index, tile] : source.tiles)
        touch(index, source.cell_size_m);
}

void HeightFusion::chooseGrid() {
    double smallest_m = std::numeric_limits<double>::infinity();
    for (const auto& [robot, source] : sources_)
        smallest_m = std::min(smallest_m, source.cell_size_m);
    if (sources_.empty() || smallest_m == cell_size_m_)
        return;
    cell_size_m_ = smallest_m;
    fused_.clear();
    ranges_.clear();
    dirty_.clear();
    from_scratch_ = true;
    for (const auto& [robot, source] : sources_)
        touchAll(source);
}

std::shared_ptr<const HeightTile> HeightFusion::fuse(GridIndex tile) const {
    std::vector<CellSource> cells;
    std::shared_ptr<const HeightTile> whole;
    for (const auto& [robot, source] : sources_) {
        const CellSource from(source.tiles, source.cell_size_m, tile, cell_size_m_);
        if (from.absent())
            continue;
        if (from.sameGrid())
            whole = source.tiles.at(tile);
        cells.push_back(from);
    }
    if (cells.size() == 1 && whole)
        return whole;
    auto fused = std::make_shared<HeightTile>();
    fused->index = tile;
    for (std::size_t offset = 0; offset < HeightTile::cell_count; ++offset) {
        CellMean mean;
        std::size_t found = 0;
        for (CellSource& from : cells)
            if (const HeightTile* const source = from.find(offset, found))
                mean.add(*source, found);
        mean.putInto(*fused, offset);
    }
    return fused;
}

HeightChange HeightFusion::takeChange() {
    HeightChange change;
    change.from_scratch = std::exchange(from_scratch_, false);
    change.cell_size_m = cell_size_m_;
    for (const GridIndex& index : std::exchange(dirty_, {})) {
        auto tile = fuse(index);
        const auto range = tile ? HeightRange::of(tile->height_m) : std::nullopt;
        if (!range) { // A tile of coarser cells touches neighbors in which it has no cell; they stay unknown.
            change.from_scratch = fused_.erase(index) > 0 || change.from_scratch;
            ranges_.erase(index);
            continue;
        }
        ranges_[index] = range;
        fused_[index] = tile;
        change.tiles.push_back(std::move(tile));
    }
    for (const auto& [index, range] : ranges_) {
        HeightRange::include(change.range, range->minimum_m);
        HeightRange::include(change.range, range->maximum_m);
    }
    if (change.from_scratch) {
        change.tiles.clear();
        for (const auto& [index, tile] : fused_)
            change.tiles.push_back(tile);
    }
    return change;
}

} // namespace usar::mapping
