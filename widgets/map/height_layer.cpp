#include "widgets/map/height_layer.h"

#include <cmath>
#include <limits>
#include <utility>

#include "core/base/hand_over.h"
#include "core/mapping/height_histogram.h"

namespace usar::widgets {
namespace {

constexpr int tile_side = mapping::HeightTile::side;
/// Heights of a whole page in the order of its picture.
using PageHeights = std::vector<float>;

std::uint32_t* scanLine(QImage& image, int y) {
    return reinterpret_cast<std::uint32_t*>(image.scanLine(y));
}
const std::uint32_t* scanLine(const QImage& image, int y) {
    return reinterpret_cast<const std::uint32_t*>(image.constScanLine(y));
}

/// Where a tile of a page is in its picture. With x up and y left the page is rotated by a quarter turn
/// counter-clockwise.
QRect rectOf(std::size_t tile, MapOrientation orientation) {
    const int last = PageTiles::tiles_per_side - 1;
    const int column = static_cast<int>(tile) % PageTiles::tiles_per_side;
    const int row = static_cast<int>(tile) / PageTiles::tiles_per_side;
    const bool x_up = orientation == MapOrientation::XUp;
    return {(x_up ? last - row : column) * tile_side, (x_up ? last - column : last - row) * tile_side, tile_side,
            tile_side};
}

/// Copies the preview of a tile into the page.
void place(PageHeights& heights_m, const mapping::HeightTile& tile, const QRect& at, MapOrientation orientation) {
    const bool x_up = orientation == MapOrientation::XUp;
    for (int y = 0; y < tile_side; ++y)
        for (int x = 0; x < tile_side; ++x) {
            const int upward = tile_side - 1 - y;
            const int cell = x_up ? (tile_side - 1 - x) * tile_side + upward : upward * tile_side + x;
            heights_m[static_cast<std::size_t>((at.top() + y) * PageTiles::side + at.left() + x)] =
                tile.preview_m[static_cast<std::size_t>(cell)];
        }
}

PageHeights heightsOf(const PageTiles& page, MapOrientation orientation) {
    PageHeights heights_m(std::size_t(PageTiles::side) * PageTiles::side, std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < page.tiles.size(); ++i)
        if (page.tiles[i])
            place(heights_m, *page.tiles[i], rectOf(i, orientation), orientation);
    return heights_m;
}

/// Mean of four premultiplied pixels, two channels at a time.
std::uint32_t mean(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    constexpr std::uint32_t mask = 0x00ff00ff;
    const std::uint32_t low = ((a & mask) + (b & mask) + (c & mask) + (d & mask)) >> 2 & mask;
    const std::uint32_t high = ((a >> 8 & mask) + (b >> 8 & mask) + (c >> 8 & mask) + (d >> 8 & mask)) >> 2 & mask;
    return low | high << 8;
}

/// Puts the reduction of a part of the image, all of whose edges are even, into an image of half the size.
void halve(const QImage& image, const QRect& part, QImage& half) {
    for (int y = part.top() / 2; y <= part.bottom() / 2; ++y) {
        const std::uint32_t* upper = scanLine(image, 2 * y);
        const std::uint32_t* lower = scanLine(image, 2 * y + 1);
        std::uint32_t* out = scanLine(half, y);
        for (int x = part.left() / 2; x <= part.right() / 2; ++x)
            out[x] = mean(upper[2 * x], upper[2 * x + 1], lower[2 * x], lower[2 * x + 1]);
    }
}

/// Paints a part of the page's picture with what `colorOf(column, row)` gives, as premultiplied pixels, and of its
/// reductions.
template <class ColorOf>
void paint(PagePicture::Levels& levels, QRect part, const ColorOf& colorOf) {
    for (std::size_t level = 0; level < levels.size(); ++level)
        if (levels[level].isNull())
            levels[level] =
                QImage(PageTiles::side >> level, PageTiles::side >> level, QImage::Format_ARGB32_Premultiplied);
    for (int row = part.top(); row <= part.bottom(); ++row) {
        std::uint32_t* out = scanLine(levels[0], row);
        for (int column = part.left(); column <= part.right(); ++column)
            out[column] = qPremultiply(colorOf(column, row));
    }
    for (std::size_t level = 1; level < levels.size(); ++level) {
        halve(levels[level - 1], part, levels[level]);
        part = QRect(part.topLeft() / 2, part.size() / 2);
    }
}

constexpr QRect whole_page(0, 0, PageTiles::side, PageTiles::side);

/// The part of a page that looks other when these tiles change: light depends on the next cell. Its edges are edges of
/// pixels in all reductions.
QRect partOf(const PageTiles::Which& changed, MapOrientation orientation) {
    constexpr int coarsest = 1 << (PagePicture::level_count - 1);
    QRect part;
    for (std::size_t i = 0; i < changed.size(); ++i)
        if (changed[i])
            part |= rectOf(i, orientation);
    return part.adjusted(-coarsest, -coarsest, coarsest, coarsest) & whole_page;
}

void renderPart(const PageTiles& page, const HeightStyle& style, const QRect& part, PagePicture& picture) {
    const PageHeights heights_m = heightsOf(page, style.orientation);
    const mapping::HeightGrid grid{heights_m, PageTiles::side, PageTiles::side, style.cell_size_m};
    paint(picture.levels, part,
          [&](int column, int row) { return mapping::shadeCell(grid, column, row, style.range, style.color_map); });
    if (style.contour_step_m > 0.0)
        paint(picture.contours, part, [&](int column, int row) {
            return mapping::contourCell(grid, column, row, style.range, style.contour_step_m);
        });
}

std::int32_t floorDivided(std::int32_t a, std::int32_t b) {
    return a / b - (a % b < 0 ? 1 : 0);
}

/// True if colors would show the difference: a scale has 256 of them.
bool looksOther(const mapping::HeightRange& range, const mapping::HeightRange& painted) {
    const float step_m = (painted.maximum_m - painted.minimum_m) / 512.0f;
    return std::abs(range.minimum_m - painted.minimum_m) > step_m ||
           std::abs(range.maximum_m - painted.maximum_m) > step_m;
}

} // namespace

std::size_t PagePicture::indexFor(double screen_pixels_per_cell) {
    std::size_t level = 0;
    while (level + 1 < level_count && screen_pixels_per_cell <= 0.5) {
        screen_pixels_per_cell *= 2.0;
        ++level;
    }
    return level;
}

double contourStep_m(const mapping::HeightRange& range) {
    return roundStep((double(range.maximum_m) - double(range.minimum_m)) / 5.0);
}

PagePicture renderPage(const PageTiles& page, const HeightStyle& style) {
    PagePicture picture;
    renderPart(page, style, whole_page, picture);
    return picture;
}

PagePicture renderAgain(const PageTiles& page, const HeightStyle& style, const PagePicture& before,
                        const PageTiles::Which& changed) {
    PagePicture picture = before;
    renderPart(page, style, partOf(changed, style.orientation), picture);
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
    trim_pause_.setSingleShot(true);
    trim_pause_.setInterval(1000);
    connect(&trim_pause_, &QTimer::timeout, this, [this] {
        const mapping::HeightRange before = range();
        if (trim_due_)
            trim();
        applyRange();
        renderNext();
        if (range() != before)
            emit changed();
    });
}

HeightLayer::~HeightLayer() {
    pool_.waitForDone();
}

void HeightLayer::clear(double cell_size_m) {
    style_.cell_size_m = cell_size_m;
    tiles_.clear();
    sources_.clear();
    pages_.clear();
    dirty_.clear();
    scan_range_.reset();
    trimmed_range_.reset();
    trim_due_ = false;
    trim_pause_.stop();
    ++generation_;
    emit changed();
}

template <class Value>
void HeightLayer::restyle(Value HeightStyle::*part, const Value& value) {
    if (std::exchange(style_.*part, value) == value)
        return;
    for (const auto& [index, source] : sources_)
        dirty_[index].set();
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
        const auto place = static_cast<std::size_t>(row * PageTiles::tiles_per_side + column);
        source.tiles[place] = tile;
        dirty_[page].set(place);
    }
    if (range)
        scan_range_ = range;
    trim();
    applyRange();
    renderNext();
}

void HeightLayer::setLook(const HeightLook& look) {
    look_ = look;
    trim_pause_.stop(); // A choice is answered at once.
    trim();
    restyle(&HeightStyle::color_map, look.color_map);
    applyRange();
    renderNext();
    emit changed();
}

void HeightLayer::setContours(bool drawn) {
    contours_ = drawn;
    applyRange();
    renderNext();
}

mapping::HeightRange HeightLayer::range() const {
    if (look_.fixed_range)
        return *look_.fixed_range;
    return (look_.trimmed && trimmed_range_ ? trimmed_range_ : scan_range_).value_or(mapping::HeightRange{});
}

void HeightLayer::trim() {
    trim_due_ = look_.trimmed && !look_.fixed_range && scan_range_;
    if (!trim_due_ || trim_pause_.isActive())
        return;
    trim_due_ = false;
    trim_pause_.start();
    mapping::HeightHistogram histogram(*scan_range_);
    for (const auto& [index, tile] : tiles_)
        histogram.add(tile->preview_m);
    trimmed_range_ = histogram.trimmed();
}

void HeightLayer::applyRange() {
    if (!rangeKnown())
        return;
    if (looksOther(range(), style_.range))
        restyle(&HeightStyle::range, range());
    restyle(&HeightStyle::contour_step_m, contours_ ? contourStep_m(style_.range) : 0.0);
}

void HeightLayer::setOrientation(MapOrientation orientation) {
    restyle(&HeightStyle::orientation, orientation);
    renderNext();
}

Rectangle HeightLayer::bounds_in_map() const {
    if (tiles_.empty())
        return {};
    const double side_m = HeightTile::side * style_.cell_size_m;
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
    return mapping::probeHeight(tiles_, style_.cell_size_m, point_in_map_m);
}

std::optional<mapping::HeightRange> HeightLayer::rangeWithin(const Rectangle& area_in_map) const {
    return mapping::rangeWithin(tiles_, style_.cell_size_m, area_in_map);
}

void HeightLayer::renderNext() {
    if (rendering_ || dirty_.empty() || !rangeKnown())
        return;
    struct Work {
        PageTiles page;
        PageTiles::Which changed;
        PagePicture before;
    };
    std::vector<Work> batch;
    batch.reserve(dirty_.size());
    for (const auto& [index, changed] : dirty_) {
        const auto before = pages_.find(index);
        const bool is_new = before == pages_.end();
        batch.push_back(
            {sources_.at(index), is_new ? PageTiles::Which().set() : changed, is_new ? PagePicture() : before->second});
    }
    dirty_.clear();
    rendering_ = true;
    pool_.start(HandedOver([this, batch = std::move(batch), style = style_, generation = generation_] {
        std::vector<std::pair<GridIndex, PagePicture>> finished;
        finished.reserve(batch.size());
        for (const auto& [page, changed, before] : batch)
            finished.emplace_back(page.index,
                                  changed.all() ? renderPage(page, style) : renderAgain(page, style, before, changed));
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
