#include "core/mission/fleet/shown_heights.h"

#include <algorithm>
#include <utility>

namespace usar::mission {

using mapping::HeightScope;

namespace {

ScanGroup groupOf(const RobotView& view) {
    return view.recording.isEmpty() ? ScanGroup::Live : ScanGroup::Replayed;
}

FusionWorker::Tiles listOf(const mapping::HeightTiles& tiles) {
    FusionWorker::Tiles list;
    list.reserve(tiles.size());
    for (const auto& [index, tile] : tiles)
        list.push_back(tile);
    return list;
}

} // namespace

void FusionWorker::take(ScanGroup group, ConnectionId robot, double cell_size_m, const Tiles& tiles,
                        bool from_scratch) {
    of(group).take(robot, cell_size_m, tiles, from_scratch);
    workSoon();
}

void FusionWorker::remove(ScanGroup group, ConnectionId robot) {
    of(group).remove(robot);
    workSoon();
}

void FusionWorker::workSoon() {
    if (std::exchange(waits_, true))
        return;
    QMetaObject::invokeMethod(
        this, [this] { work(); }, Qt::QueuedConnection);
}

void FusionWorker::work() {
    waits_ = false;
    for (const ScanGroup group : {ScanGroup::Live, ScanGroup::Replayed})
        if (of(group).changed())
            emit fused(group, std::make_shared<const mapping::HeightChange>(of(group).takeChange()));
}

ShownHeights::ShownHeights(const Fleet& fleet) : fleet_(fleet) {
    connect(&fleet, &Fleet::robotUpdated, this, [this](RobotId id, const auto& update) { take(id, *update); });
    connect(&fleet, &Fleet::robotRemoved, this, [this](RobotId id) { remove(id); });
    link::connectAcross(worker_.get(), &FusionWorker::fused, this,
                        [this](ScanGroup group, const auto& change) { takeFused(group, *change); });
}

void ShownHeights::setScope(HeightScope scope) {
    if (std::exchange(scope_, scope) != scope)
        tellAll();
}

const RobotView* ShownHeights::viewOf(RobotId id) const {
    const Robot* const robot = fleet_.robot(id);
    return robot ? &robot->view() : nullptr;
}

void ShownHeights::select(RobotId id) {
    const bool again = std::exchange(selected_, id) == id;
    const RobotView* const view = viewOf(id);
    const ScanGroup group = view ? groupOf(*view) : ScanGroup::Live;
    const bool other_group = std::exchange(group_, group) != group;
    if (again || other_group || scope_ == HeightScope::SelectedRobot)
        tellAll();
}

void ShownHeights::tellAll() {
    const RobotView* const view = viewOf(selected_);
    const bool fused = scope_ == HeightScope::AllRobots;
    const Fused nothing;
    told_cell_size_m_ = fused ? shownFused().cell_size_m : view ? view->cell_size_m : nothing.cell_size_m;
    emit begun(told_cell_size_m_);
    if (fused)
        emit grown(listOf(shownFused().tiles), shownFused().range);
    else if (view)
        emit grown(listOf(view->tiles), view->height_range);
}

void ShownHeights::take(RobotId id, const SessionUpdate& update) {
    const RobotView* const view = viewOf(id);
    if (!view)
        return;
    if (!update.tiles.empty() || update.rewound) {
        members_[id] = {view->connection, groupOf(*view)};
        worker_.call(&FusionWorker::take, groupOf(*view), view->connection, view->cell_size_m, update.tiles,
                     update.rewound);
    }
    if (id != selected_ || scope_ == HeightScope::AllRobots)
        return;
    if (update.rewound || view->cell_size_m != told_cell_size_m_)
        tellAll();
    else if (!update.tiles.empty())
        emit grown(update.tiles, update.height_range);
}

void ShownHeights::takeFused(ScanGroup group, const mapping::HeightChange& change) {
    Fused& fused = fused_[static_cast<std::size_t>(group)];
    if (change.from_scratch)
        fused.tiles.clear();
    for (const auto& tile : change.tiles)
        fused.tiles[tile->index] = tile;
    fused.range = change.range;
    const bool other_cells = std::exchange(fused.cell_size_m, change.cell_size_m) != change.cell_size_m;
    if (group != group_ || scope_ == HeightScope::SelectedRobot)
        return;
    if (change.from_scratch || other_cells)
        tellAll();
    else
        emit grown(change.tiles, change.range);
}

void ShownHeights::remove(RobotId id) {
    const auto left = members_.extract(id);
    if (!left.empty())
        worker_.call(&FusionWorker::remove, left.mapped().group, left.mapped().connection);
}

QStringList ShownHeights::knowing(const Vec2& point_in_map_m) const {
    auto sources = sourcesAt(point_in_map_m);
    std::ranges::sort(sources, {}, [](const auto& source) { return source.first.value; });
    QStringList known;
    for (const auto& [id, probe] : sources)
        known << nameOf(*fleet_.robot(id));
    return known;
}

std::vector<std::pair<RobotId, mapping::HeightProbe>> ShownHeights::sourcesAt(const Vec2& point_in_map_m) const {
    std::vector<std::pair<RobotId, mapping::HeightProbe>> sources;
    for (const Robot* const robot : fleet_.robots()) {
        const RobotView& view = robot->view();
        const bool shown = scope_ == HeightScope::AllRobots ? groupOf(view) == group_ : view.id == selected_;
        if (!shown)
            continue;
        if (const auto probe = mapping::probeHeight(view.tiles, view.cell_size_m, point_in_map_m))
            sources.emplace_back(view.id, *probe);
    }
    std::ranges::stable_partition(sources, [this](const auto& source) { return source.first == selected_; });
    return sources;
}

} // namespace usar::mission
