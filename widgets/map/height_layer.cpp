#include "widgets/map/height_layer.h"

#include <limits>
#include <utility>

#include "core/base/hand_over.h"

namespace usar::widgets {

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

void HeightLayer::setColorMap(mapping::ColorMap color_map) {
    restyle(&HeightStyle::color_map, color_map);
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

std::optional<HeightProbe> HeightLayer::probe(const Vec2& point_in_map_m) const {
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
