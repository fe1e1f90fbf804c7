#include "core/mapping/height_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

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
    const double cell = std::floor(coordinate_m / cell_size_m);
    // The comparison is false for NaN, whose cast would be undefined behavior.
    return cell > -limit ? static_cast<std::int32_t>(std::min(cell, limit)) : static_cast<std::int32_t>(-limit);
}

} // namespace

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

void HeightMap::note(Slot& slot, std::size_t offset, float height_m, LineNumber line) {
    slot.tile.preview_m[offset] = height_m;
    slot.tile.line[offset] = line.value;
    if (!slot.changed) {
        slot.changed = true;
        changed_.push_back(slot.tile.index);
    }
    if (!range_)
        range_ = HeightRange{height_m, height_m};
    range_->minimum_m = std::min(range_->minimum_m, height_m);
    range_->maximum_m = std::max(range_->maximum_m, height_m);
}

void HeightMap::write(GridIndex cell, float height_m, LineNumber line) {
    if (!std::isfinite(height_m))
        return;
    Slot& slot = slotFor(cell);
    const std::size_t offset = offsetOf(cell);
    float& known_m = slot.tile.height_m[offset];
    std::uint16_t& hits = slot.tile.hits[offset];
    if (std::isnan(known_m))
        ++known_cells_;
    known_m = hits == 0 ? height_m : (known_m + height_m) / 2.0f;
    if (hits < std::numeric_limits<std::uint16_t>::max())
        ++hits;
    note(slot, offset, height_m, line);
}

void HeightMap::fill(GridIndex cell, float height_m, LineNumber line) {
    if (!std::isfinite(height_m))
        return;
    Slot& slot = slotFor(cell);
    const std::size_t offset = offsetOf(cell);
    if (slot.tile.hits[offset] > 0)
        return;
    float& known_m = slot.tile.height_m[offset];
    if (std::isnan(known_m)) {
        ++known_cells_;
        known_m = height_m;
    } else {
        known_m = (known_m + height_m) / 2.0f;
    }
    note(slot, offset, height_m, line);
}

std::optional<float> HeightMap::height_m(GridIndex cell) const {
    const HeightTile* found = tile(tileOf(cell));
    if (!found || std::isnan(found->height_m[offsetOf(cell)]))
        return std::nullopt;
    return found->height_m[offsetOf(cell)];
}

std::optional<float> HeightMap::preview_m(GridIndex cell) const {
    const HeightTile* found = tile(tileOf(cell));
    if (!found || std::isnan(found->preview_m[offsetOf(cell)]))
        return std::nullopt;
    return found->preview_m[offsetOf(cell)];
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
    if (tiles_.empty())
        return std::nullopt;
    GridIndex low = tiles_.begin()->first;
    GridIndex high = low;
    for (const auto& [index, slot] : tiles_) {
        low = {std::min(low.column, index.column), std::min(low.row, index.row)};
        high = {std::max(high.column, index.column), std::max(high.row, index.row)};
    }
    constexpr std::int32_t side = HeightTile::side;
    return CellBounds{{low.column * side, low.row * side}, {high.column * side + side - 1, high.row * side + side - 1}};
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

} // namespace usar::mapping
