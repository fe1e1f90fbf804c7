#include "core/mapping/height_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/whole_number.h"

namespace usar::mapping {

namespace {

constexpr int side_bits = 6;
static_assert(HeightTile::side == 1 << side_bits);

GridIndex tileOf(GridIndex cell) {
    return {cell.column >> side_bits, cell.row >> side_bits};
}

std::size_t offsetOf(GridIndex cell) {
    constexpr std::int32_t mask = HeightTile::side - 1;
    return static_cast<std::size_t>((cell.row & mask) * HeightTile::side + (cell.column & mask));
}

std::int32_t cellIndex(double coordinate_m, double cell_size_m) {
    constexpr double limit = 1 << 30;
    const double cell = coordinate_m / cell_size_m;
    // The comparison is false for NaN, whose cast would be undefined behavior.
    return static_cast<std::int32_t>(cell > -limit ? wholeBelow(std::min(cell, limit)) : wholeBelow(-limit));
}

/// The height of a cell in one of the tile's arrays; nullopt if it is unknown or there is no tile.
std::optional<float> knownHeight(const HeightTile* tile, decltype(HeightTile::height_m) HeightTile::*heights_m,
                                 GridIndex cell) {
    if (!tile || std::isnan((tile->*heights_m)[offsetOf(cell)]))
        return std::nullopt;
    return (tile->*heights_m)[offsetOf(cell)];
}

} // namespace

void HeightRange::include(std::optional<HeightRange>& range, float height_m) {
    if (!range)
        range = {height_m, height_m};
    range->minimum_m = std::min(range->minimum_m, height_m);
    range->maximum_m = std::max(range->maximum_m, height_m);
}

std::optional<HeightRange> HeightRange::of(std::span<const float> heights_m) {
    std::optional<HeightRange> range;
    for (const float height_m : heights_m)
        if (!std::isnan(height_m))
            include(range, height_m);
    return range;
}

void CellBounds::include(std::optional<CellBounds>& bounds, GridIndex cell) {
    if (!bounds)
        bounds = {cell, cell};
    bounds->first = {std::min(bounds->first.column, cell.column), std::min(bounds->first.row, cell.row)};
    bounds->last = {std::max(bounds->last.column, cell.column), std::max(bounds->last.row, cell.row)};
}

HeightTile::HeightTile() {
    height_m.fill(std::numeric_limits<float>::quiet_NaN());
    preview_m.fill(std::numeric_limits<float>::quiet_NaN());
    hits.fill(0);
    line.fill(0);
}

HeightMap::HeightMap(double cell_size_m) : cell_size_m_(cell_size_m) {
    assert(std::isfinite(cell_size_m) && cell_size_m > 0.0);
}

GridIndex HeightMap::cellAt(const Vec2& point_in_map_m) const {
    return {cellIndex(point_in_map_m.x(), cell_size_m_), cellIndex(point_in_map_m.y(), cell_size_m_)};
}

Vec2 HeightMap::center_m(GridIndex cell) const {
    return Vec2(cell.column + 0.5, cell.row + 0.5) * cell_size_m_;
}

HeightMap::Slot& HeightMap::slotFor(GridIndex cell) {
    const GridIndex index = tileOf(cell);
    if (last_slot_ && last_slot_->tile.index == index)
        return *last_slot_;
    std::unique_ptr<Slot>& slot = tiles_[index];
    if (!slot) {
        slot = std::make_unique<Slot>();
        slot->tile.index = index;
    }
    last_slot_ = slot.get();
    return *slot;
}

void HeightMap::record(GridIndex cell, float height_m, LineNumber line, bool measured) {
    if (!std::isfinite(height_m))
        return;
    Slot& slot = slotFor(cell);
    const std::size_t offset = offsetOf(cell);
    float& known_m = slot.tile.height_m[offset];
    std::uint16_t& hits = slot.tile.hits[offset];
    if (!measured && hits > 0)
        return;
    const bool is_new = std::isnan(known_m);
    known_cells_ += is_new;
    known_m = is_new || (measured && hits == 0) ? height_m : (known_m + height_m) / 2.0f;
    if (measured && hits < std::numeric_limits<std::uint16_t>::max())
        ++hits;
    slot.tile.preview_m[offset] = height_m;
    slot.tile.line[offset] = line.value;
    noteChange(slot);
}

void HeightMap::settle(GridIndex cell, float height_m) {
    if (!std::isfinite(height_m) || !this->height_m(cell))
        return;
    Slot& slot = slotFor(cell);
    slot.tile.height_m[offsetOf(cell)] = height_m;
    noteChange(slot);
}

void HeightMap::noteChange(Slot& slot) {
    if (!std::exchange(slot.changed, true))
        changed_.push_back(slot.tile.index);
    slot.range_old = true;
}

void HeightMap::addTile(GridIndex tile_index) {
    constexpr std::int32_t side = HeightTile::side;
    noteChange(slotFor({tile_index.column * side, tile_index.row * side}));
}

std::optional<HeightRange> HeightMap::range() const {
    std::optional<HeightRange> all;
    for (const auto& [index, slot] : tiles_) {
        if (std::exchange(slot->range_old, false))
            slot->range = HeightRange::of(slot->tile.height_m);
        if (slot->range) {
            HeightRange::include(all, slot->range->minimum_m);
            HeightRange::include(all, slot->range->maximum_m);
        }
    }
    return all;
}

std::optional<float> HeightMap::height_m(GridIndex cell) const {
    return knownHeight(tile(tileOf(cell)), &HeightTile::height_m, cell);
}

std::optional<float> HeightMap::preview_m(GridIndex cell) const {
    return knownHeight(tile(tileOf(cell)), &HeightTile::preview_m, cell);
}

int HeightMap::hits(GridIndex cell) const {
    const HeightTile* found = tile(tileOf(cell));
    return found ? found->hits[offsetOf(cell)] : 0;
}

LineNumber HeightMap::line(GridIndex cell) const {
    const HeightTile* found = tile(tileOf(cell));
    return found ? LineNumber{found->line[offsetOf(cell)]} : LineNumber{};
}

std::optional<CellBounds> HeightMap::bounds() const {
    std::optional<CellBounds> tiles;
    for (const auto& [index, slot] : tiles_)
        CellBounds::include(tiles, index);
    if (!tiles)
        return std::nullopt;
    constexpr std::int32_t side = HeightTile::side;
    return CellBounds{{tiles->first.column * side, tiles->first.row * side},
                      {tiles->last.column * side + side - 1, tiles->last.row * side + side - 1}};
}

std::size_t HeightMap::memoryBytes() const {
    constexpr std::size_t node_bytes = sizeof(GridIndex) + 5 * sizeof(void*);
    return sizeof(*this) + tiles_.size() * (sizeof(Slot) + node_bytes) + changed_.capacity() * sizeof(GridIndex);
}

const HeightTile* HeightMap::tile(GridIndex tile_index) const {
    const auto found = tiles_.find(tile_index);
    return found == tiles_.end() ? nullptr : &found->second->tile;
}

std::vector<GridIndex> HeightMap::tileIndices() const {
    std::vector<GridIndex> indices;
    indices.reserve(tiles_.size());
    for (const auto& [index, slot] : tiles_)
        indices.push_back(index);
    return indices;
}

std::vector<std::shared_ptr<const HeightTile>> HeightMap::takeChangedTiles() {
    std::vector<std::shared_ptr<const HeightTile>> copies;
    copies.reserve(changed_.size());
    for (const GridIndex& index : std::exchange(changed_, {})) {
        Slot& slot = *tiles_.find(index)->second;
        slot.changed = false;
        copies.push_back(std::make_shared<const HeightTile>(slot.tile));
    }
    return copies;
}

std::optional<HeightProbe> probeHeight(const HeightTiles& tiles, double cell_size_m, const Vec2& point_in_map_m) {
    const Vec2 position = (point_in_map_m / cell_size_m).array().floor().matrix();
    if (!(position.cwiseAbs().maxCoeff() < 1e9)) // also true for NaN
        return std::nullopt;
    const GridIndex cell{static_cast<std::int32_t>(position.x()), static_cast<std::int32_t>(position.y())};
    const auto found = tiles.find(tileOf(cell));
    const auto height_m =
        knownHeight(found == tiles.end() ? nullptr : found->second.get(), &HeightTile::height_m, cell);
    if (!height_m)
        return std::nullopt;
    const HeightTile& tile = *found->second;
    return HeightProbe{*height_m, tile.hits[offsetOf(cell)], {tile.line[offsetOf(cell)]}};
}

std::optional<HeightRange> rangeWithin(const HeightTiles& tiles, double cell_size_m, const Rectangle& area_in_map) {
    const auto cell_at = [cell_size_m](const Vec2& at_m) {
        return GridIndex{cellIndex(at_m.x(), cell_size_m), cellIndex(at_m.y(), cell_size_m)};
    };
    const GridIndex first = cell_at(area_in_map.min_m), last = cell_at(area_in_map.max_m);
    std::optional<HeightRange> range;
    for (const auto& [index, tile] : tiles) {
        // Distances between cells at both ends of the grid are longer than 32 bits.
        constexpr std::int64_t side = HeightTile::side;
        const std::int64_t left = std::max<std::int64_t>(first.column - index.column * side, 0);
        const std::int64_t right = std::min(last.column - index.column * side, side - 1);
        const std::int64_t bottom = std::max<std::int64_t>(first.row - index.row * side, 0);
        const std::int64_t top = std::min(last.row - index.row * side, side - 1);
        for (std::int64_t row = bottom; left <= right && row <= top; ++row) {
            const std::span all(tile->height_m);
            const auto part = HeightRange::of(
                all.subspan(static_cast<std::size_t>(row * side + left), static_cast<std::size_t>(right - left + 1)));
            if (!part)
                continue;
            HeightRange::include(range, part->minimum_m);
            HeightRange::include(range, part->maximum_m);
        }
    }
    return range;
}

} // namespace usar::mapping
