#include "widgets/map/height_layer.h"

#include <cmath>
#include <limits>
#include <utility>

#include "core/base/hand_over.h"
#include "core/mapping/height_histogram.h"

namespace usar::widgets {

using mapping::GridIndex;
using mapping::HeightTile;

namespace {

/// True if colors would show the difference: a scale has 256 of them.
bool looksOther(const mapping::HeightRange& range, const mapping::HeightRange& painted) {
    const float step_m = (painted.maximum_m - painted.minimum_m) / 512.0f;
    return std::abs(range.minimum_m - painted.minimum_m) > step_m ||
           std::abs(range.maximum_m - painted.maximum_m) > step_m;
}

} // namespace

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
    dirty_px_.clear();
    scan_range_.reset();
    trimmed_range_.reset();
    trim_due_ = false;
    trim_pause_.stop();
    ++generation_;
    emit cleared();
    emit changed();
}

template <class Value>
void HeightLayer::restyle(Value HeightStyle::*part, const Value& value) {
    if (std::exchange(style_.*part, value) == value)
        return;
    for (const auto& [index, source] : sources_)
        dirty_px_[index] = PageTiles::whole;
}

void HeightLayer::takeTile(const std::shared_ptr<const HeightTile>& tile) {
    std::shared_ptr<const HeightTile>& known = tiles_[tile->index];
    const GridIndex page = pageOfTile(tile->index);
    PageTiles& source = sources_[page];
    source.index = page;
    const int column = tile->index.column - page.column * PageTiles::tiles_per_side;
    const int row = tile->index.row - page.row * PageTiles::tiles_per_side;
    const auto place = static_cast<std::size_t>(row * PageTiles::tiles_per_side + column);
    const QRect changed_px = changedPixels(place, known.get(), *tile, style_.orientation);
    if (!changed_px.isEmpty())
        dirty_px_[page] |= changed_px;
    source.tiles[place] = tile;
    known = tile;
}

void HeightLayer::take(const std::vector<std::shared_ptr<const HeightTile>>& tiles,
                       const std::optional<mapping::HeightRange>& range) {
    for (const auto& tile : tiles)
        takeTile(tile);
    emit tilesTaken(tiles);
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
    if (rendering_ || dirty_px_.empty() || !rangeKnown())
        return;
    struct Work {
        PageTiles page;
        QRect changed_px;
        PagePicture before;
    };
    std::vector<Work> batch;
    batch.reserve(dirty_px_.size());
    Rectangle ground = groundUnder(partOf(dirty_px_.begin()->second), dirty_px_.begin()->first, style_);
    for (const auto& [index, changed_px] : dirty_px_) {
        const auto before = pages_.find(index);
        const bool is_new = before == pages_.end();
        batch.push_back(
            {sources_.at(index), is_new ? PageTiles::whole : changed_px, is_new ? PagePicture() : before->second});
        const Rectangle more = groundUnder(partOf(changed_px), index, style_);
        ground = {ground.min_m.cwiseMin(more.min_m), ground.max_m.cwiseMax(more.max_m)};
    }
    dirty_px_.clear();
    rendering_ = true;
    pool_.start(HandedOver([this, batch = std::move(batch), style = style_, generation = generation_, ground] {
        Finished finished{{}, ground, generation};
        finished.pages.reserve(batch.size());
        for (const auto& [page, changed_px, before] : batch)
            finished.pages.emplace_back(page.index, changed_px == PageTiles::whole
                                                        ? renderPage(page, style)
                                                        : renderAgain(page, style, before, changed_px));
        // The destructor waits for this worker, so `this` is valid here; if the object is destroyed, the queued call is
        // discarded.
        QMetaObject::invokeMethod(
            this, HandedOver([this, finished = std::move(finished)]() mutable { swapIn(std::move(finished)); }),
            Qt::QueuedConnection);
    }));
}

void HeightLayer::swapIn(Finished finished) {
    rendering_ = false;
    if (finished.generation == generation_) {
        for (auto& [index, picture] : finished.pages)
            pages_[index] = std::move(picture);
        emit groundChanged(finished.ground_in_map);
        emit changed();
    }
    renderNext();
}

} // namespace usar::widgets
