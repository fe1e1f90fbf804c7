#include "widgets/map/height_layer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/hand_over.h"

namespace usar::widgets {
namespace {

constexpr int tile_side = mapping::HeightTile::side;
using TilePixels = std::array<std::uint32_t, mapping::HeightTile::cell_count>;

std::uint32_t* scanLine(QImage& image, int y) {
    return reinterpret_cast<std::uint32_t*>(image.scanLine(y));
}
const std::uint32_t* scanLine(const QImage& image, int y) {
    return reinterpret_cast<const std::uint32_t*>(image.constScanLine(y));
}

/// Copies a tile into the picture. `pixels` have x to the right and y up; with x up and y left the picture is rotated
/// by a quarter turn counter-clockwise.
void place(QImage& image, const TilePixels& pixels, int tile_column, int tile_row, MapOrientation orientation) {
    const int last = PageTiles::tiles_per_side - 1;
    const bool x_up = orientation == MapOrientation::XUp;
    const int left = (x_up ? last - tile_row : tile_column) * tile_side;
    const int top = (x_up ? last - tile_column : last - tile_row) * tile_side;
    for (int y = 0; y < tile_side; ++y) {
        std::uint32_t* out = scanLine(image, top + y) + left;
        for (int x = 0; x < tile_side; ++x)
            out[x] = pixels[static_cast<std::size_t>(x_up ? x * tile_side + (tile_side - 1 - y) : y * tile_side + x)];
    }
}

/// Mean of four premultiplied pixels, two channels at a time.
std::uint32_t mean(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    constexpr std::uint32_t mask = 0x00ff00ff;
    const std::uint32_t low = ((a & mask) + (b & mask) + (c & mask) + (d & mask)) >> 2 & mask;
    const std::uint32_t high = ((a >> 8 & mask) + (b >> 8 & mask) + (c >> 8 & mask) + (d >> 8 & mask)) >> 2 & mask;
    return low | high << 8;
}

QImage halved(const QImage& image) {
    QImage half(image.width() / 2, image.height() / 2, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < half.height(); ++y) {
        const std::uint32_t* upper = scanLine(image, 2 * y);
        const std::uint32_t* lower = scanLine(image, 2 * y + 1);
        std::uint32_t* out = scanLine(half, y);
        for (int x = 0; x < half.width(); ++x)
            out[x] = mean(upper[2 * x], upper[2 * x + 1], lower[2 * x], lower[2 * x + 1]);
    }
    return half;
}

std::int32_t floorDivided(std::int32_t a, std::int32_t b) {
    return a / b - (a % b < 0 ? 1 : 0);
}

} // namespace

const QImage& PagePicture::levelFor(double screen_pixels_per_cell) const {
    std::size_t level = 0;
    while (level + 1 < level_count && screen_pixels_per_cell <= 0.5) {
        screen_pixels_per_cell *= 2.0;
        ++level;
    }
    return levels[level];
}

PagePicture renderPage(const PageTiles& page, const HeightStyle& style) {
    PagePicture picture;
    QImage& full = picture.levels[0];
    full = QImage(PageTiles::side, PageTiles::side, QImage::Format_ARGB32_Premultiplied);
    full.fill(Qt::transparent);
    auto pixels = std::make_unique<TilePixels>();
    for (std::size_t i = 0; i < page.tiles.size(); ++i) {
        if (!page.tiles[i])
            continue;
        mapping::shadeTile(*page.tiles[i], style.range, mapping::ColorMap::Gray, *pixels);
        // Shades are opaque or fully transparent; a transparent premultiplied pixel is zero in every channel.
        std::ranges::replace_if(
            *pixels, [](std::uint32_t pixel) { return pixel >> 24 == 0; }, 0u);
        place(full, *pixels, static_cast<int>(i) % PageTiles::tiles_per_side,
              static_cast<int>(i) / PageTiles::tiles_per_side, style.orientation);
    }
    for (std::size_t level = 1; level < PagePicture::level_count; ++level)
        picture.levels[level] = halved(picture.levels[level - 1]);
    return picture;
}

mapping::GridIndex pageOfTile(mapping::GridIndex tile) {
    return {floorDivided(tile.column, PageTiles::tiles_per_side), floorDivided(tile.row, PageTiles::tiles_per_side)};
}

Rectangle pageRectangle(mapping::GridIndex page, double cell_size_m) {
    const double side_m = PageTiles::side * cell_size_m;
    const Vec2 corner(page.column * side_m, page.row * side_m);
    return {corner, corner + Vec2(side_m, side_m)};
}

using mapping::GridIndex;
using mapping::HeightTile;

HeightLayer::HeightLayer(QObject* parent) : QObject(parent) {
    pool_.setMaxThreadCount(1);
}

HeightLayer::~HeightLayer() {
    pool_.waitForDone();
}

void HeightLayer::clear(double cell_size_m) {
    cell_size_m_ = cell_size_m;
    tiles_.clear();
    sources_.clear();
    pages_.clear();
    dirty_.clear();
    range_known_ = false;
    ++generation_;
    emit changed();
}

template <class Value>
void HeightLayer::restyle(Value HeightStyle::*part, const Value& value) {
    if (std::exchange(style_.*part, value) == value)
        return;
    for (const auto& [index, source] : sources_)
        dirty_.insert(index);
}

void HeightLayer::take(const std::vector<std::shared_ptr<const HeightTile>>& tiles,
                       const std::optional<mapping::HeightRange>& range) {
    for (const auto& tile : tiles) {
        tiles_[tile->index] = tile;
        const GridIndex page = pageOfTile(tile->index);
        PageTiles& source = sources_[page];
        source.index = page;
        const int column = tile->index.column - page.column * PageTiles::tiles_per_side;
        const int row = tile->index.row - page.row * PageTiles::tiles_per_side;
        source.tiles[static_cast<std::size_t>(row * PageTiles::tiles_per_side + column)] = tile;
        dirty_.insert(page);
    }
    if (range && (!range_known_ || *range != style_.range)) {
        range_known_ = true;
        restyle(&HeightStyle::range, *range);
    }
    renderNext();
}

void HeightLayer::setOrientation(MapOrientation orientation) {
    restyle(&HeightStyle::orientation, orientation);
    renderNext();
}

Rectangle HeightLayer::bounds_in_map() const {
    if (tiles_.empty())
        return {};
    const double side_m = HeightTile::side * cell_size_m_;
    const double huge = std::numeric_limits<double>::max();
    Rectangle bounds{Vec2(huge, huge), Vec2(-huge, -huge)};
    for (const auto& [index, tile] : tiles_) {
        const Vec2 corner(index.column * side_m, index.row * side_m);
        bounds.min_m = bounds.min_m.cwiseMin(corner);
        bounds.max_m = bounds.max_m.cwiseMax(Vec2(corner + Vec2(side_m, side_m)));
    }
    return bounds;
}

std::optional<mapping::HeightProbe> HeightLayer::probe(const Vec2& point_in_map_m) const {
    return mapping::probeHeight(tiles_, cell_size_m_, point_in_map_m);
}

void HeightLayer::renderNext() {
    if (rendering_ || dirty_.empty() || !range_known_)
        return;
    std::vector<PageTiles> batch;
    batch.reserve(dirty_.size());
    for (const GridIndex index : dirty_)
        batch.push_back(sources_.at(index));
    dirty_.clear();
    rendering_ = true;
    pool_.start(HandedOver([this, batch = std::move(batch), style = style_, generation = generation_] {
        std::vector<std::pair<GridIndex, PagePicture>> finished;
        finished.reserve(batch.size());
        for (const PageTiles& page : batch)
            finished.emplace_back(page.index, renderPage(page, style));
        // The destructor waits for this worker, so `this` is valid here; if the object is destroyed, the queued call is
        // discarded.
        QMetaObject::invokeMethod(this, HandedOver([this, finished = std::move(finished), generation]() mutable {
                                      swapIn(std::move(finished), generation);
                                  }),
                                  Qt::QueuedConnection);
    }));
}

void HeightLayer::swapIn(std::vector<std::pair<GridIndex, PagePicture>> finished, int generation) {
    rendering_ = false;
    if (generation == generation_) {
        for (auto& [index, picture] : finished)
            pages_[index] = std::move(picture);
        emit changed();
    }
    renderNext();
}

} // namespace usar::widgets
