#include "core/mission/session/scan_book.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "core/base/numbers.h"
#include "core/mapping/area_cells.h"
#include "core/mapping/deviation.h"
#include "core/mapping/raster_export.h"

namespace usar::mission {

namespace {

constexpr double farthest_m = 1e5; ///< from the origin; a position that is farther away is garbled

/// Writes the known cells of the tile into the map. They are of no line of this connection.
void addCells(const mapping::HeightTile& tile, mapping::HeightMap& map) {
    constexpr std::int32_t side = mapping::HeightTile::side;
    for (std::int32_t row = 0; row < side; ++row)
        for (std::int32_t column = 0; column < side; ++column) {
            const auto at = static_cast<std::size_t>(row * side + column);
            const mapping::GridIndex cell{tile.index.column * side + column, tile.index.row * side + row};
            if (tile.hits[at] > 0)
                map.write(cell, tile.height_m[at], {});
            else // ignored where the height is unknown
                map.fill(cell, tile.height_m[at], {});
        }
}

PathShift shiftOf(const std::vector<CorrectedPoint>& path) {
    PathShift shift;
    for (const CorrectedPoint& point : path) {
        const double by_m = (point.corrected_m - point.estimated_m).norm();
        shift.mean_m += by_m / static_cast<double>(path.size());
        shift.greatest_m = std::max(shift.greatest_m, by_m);
    }
    return shift;
}

/// A sentence after another one.
std::string shiftWords(const PathShift& shift) {
    return " The path was moved by " + fixed(shift.mean_m, 2) + " m on average and " + fixed(shift.greatest_m, 2) +
           " m at most.";
}

std::shared_ptr<const std::vector<Vec2>> fromAbove(const std::vector<CorrectedPoint>& path) {
    auto points_m = std::make_shared<std::vector<Vec2>>();
    points_m->reserve(path.size());
    for (const CorrectedPoint& point : path)
        points_m->push_back(point.corrected_m.head<2>());
    return points_m;
}

} // namespace

void ScanBook::rewind() {
    mapper_.clearMap();
    adjuster_.forget();
    earlier_tiles_.clear();
    whole_area_in_map_.reset();
    ScanRecord empty;
    empty.level = std::move(record_.level);
    record_ = std::move(empty);
    unplaced_said_ = false;
}

void ScanBook::beginReplay(std::optional<double> cell_size_m, const std::string& level) {
    mapper_.clearMap(cell_size_m);
    adjuster_.forget();
    earlier_tiles_.clear();
    record_.scans.reset();
    record_.adjustment.reset();
    record_.level = level;
}

void ScanBook::beginTask(const std::string& behavior_id, const std::string& robot_name, const Rectangle& area_in_map) {
    record_.behavior_id = behavior_id;
    record_.robot_name = robot_name;
    record_.area_in_map = std::exchange(whole_area_in_map_, std::nullopt).value_or(area_in_map);
    record_.status = {};
    record_.course = {};
}

void ScanBook::continueScan(const EarlierScan& earlier) {
    whole_area_in_map_ = earlier.record.area_in_map;
    if (mapper_.map().knownCellCount() > 0)
        return;
    earlier_tiles_ = earlier.tiles;
    mapper_.replaceMap(emptyMap());
    const std::string level = record_.level.empty() ? earlier.record.level : record_.level;
    record_ = earlier.record;
    record_.level = level;
    record_.status = {};
    record_.faults.clear();
    record_.continues = earlier.run;
    record_.adjustment.reset(); // It is that of the earlier run.
    adjuster_.forget();
    worthSaving();
}

void ScanBook::take(const protocol::InfoLine& line) {
    if (const auto* scan = std::get_if<protocol::RangeScan>(&line.message))
        mapper_.takeScan(*scan, line.number);
    else if (const auto* configuration = std::get_if<protocol::ConfigurationInfo>(&line.message))
        mapper_.takeConfiguration(*configuration);
    else if (const auto* geometry = std::get_if<protocol::GeometryInfo>(&line.message))
        mapper_.takeGeometry(*geometry);
    else if (const auto* truth = std::get_if<protocol::GroundTruthReading>(&line.message))
        mapper_.takeTruth(*truth);
    else if (const auto* response = std::get_if<protocol::Response>(&line.message))
        mapper_.takeResponse(*response);
    else if (const auto* game = std::get_if<protocol::GameInfo>(&line.message))
        record_.level = game->level;
    if (!adjustPart() && adjusts_ && adjusts_in_flight_ && !passes_on_)
        adjuster_.followFlight();
}

void ScanBook::take(const agent::Published& value) {
    if (const auto* placement = std::get_if<agent::ScanPlacement>(&value)) {
        takePlacement(*placement);
    } else if (const auto* status = std::get_if<agent::BehaviorStatus>(&value)) {
        takeStatus(*status);
    } else if (const auto* pose = std::get_if<agent::PoseEstimate>(&value)) {
        takePose(*pose);
    } else if (const auto* mark = std::get_if<agent::MapMark>(&value)) {
        record_.marks.push_back(*mark);
        worthSaving();
    }
}

void ScanBook::takePlacement(const agent::ScanPlacement& placement) {
    if (mapper_.place(placement))
        worthSaving();
    else if (!std::exchange(unplaced_said_, true))
        notices_.say(Severity::Warning, Topic::Placement,
                     "The behavior placed a scan that is too old to be known; the scan is left out.");
}

void ScanBook::takeStatus(const agent::BehaviorStatus& status) {
    const bool news = status.state != record_.status.state || status.charges != record_.status.charges ||
                      status.distance_flown_m != record_.status.distance_flown_m;
    record_.status = status;
    if (news)
        worthSaving();
    if (!record_.course.due(status.elapsed))
        return;
    if (const auto covered_pct = mapping::coverage_pct(mapper_.map(), record_.area_in_map))
        record_.course.add({status.elapsed, *covered_pct});
}

void ScanBook::takePose(const agent::PoseEstimate& estimate) {
    // It has landed, and stands still for a while.
    if (mapper_.takePose(estimate) && adjuster_.hasNews(landing_shares_))
        beginAdjustment();
    const Vec3& point_m = estimate.base_in_map.position_m;
    if (record_.path_m.empty() || (point_m - record_.path_m.back()).norm() >= cellSize_m()) {
        record_.path_m.push_back(point_m);
        worthSaving();
    }
}

void ScanBook::setCellSize(double cell_size_m) {
    if (cellSize_m() == cell_size_m)
        return;
    if (mapper_.map().tileCount() == 0) {
        adjuster_.forget(); // It would look for scans that are gone.
        return mapper_.clearMap(cell_size_m);
    }
    notices_.say(Severity::Warning, Topic::CellSize,
                 "The height map keeps its cells of " + fixed(cellSize_m(), 2) +
                     " m, because it already has heights. Remove the robot and spawn it again to map with cells of " +
                     fixed(cell_size_m, 2) + " m.");
}

void ScanBook::setAdjust(bool on) {
    adjusts_ = on;
    mapper_.improve(on);
    if (!on)
        mapper_.setError({});
}

void ScanBook::beginAdjustment() {
    if (!adjusts_ || !adjuster_.hasNews())
        return;
    if (waits())
        adjuster_.note();
    else
        adjuster_.begin();
}

/// Once the scans take half of the room that there is, landings are adjusted on the way, too: the scans may be gone
/// when it is over.
bool ScanBook::waits() const {
    return passes_on_ && mapper_.store().memoryBytes() < mapping::ScanStore::most_bytes / 2;
}

void ScanBook::passOn(bool on) {
    passes_on_ = on;
    if (!on)
        adjuster_.beginNoted();
}

bool ScanBook::adjustPart() {
    if (waits() || !adjuster_.step())
        return false;
    const auto& result = adjuster_.result();
    if (!result || adjuster_.busy())
        return true;
    MapAdjustment adjustment{result->verdict, result->reason, result->residual_before_m, result->residual_after_m,
                             result->overlaps};
    if (const std::vector<CorrectedPoint> path = correctedPath(); !path.empty()) {
        adjustment.shift = shiftOf(path);
        adjustment.corrected_m = fromAbove(path);
    } else if (record_.adjustment && !result->correction.sorties.empty()) { // The scans are gone, the map is as it was.
        adjustment.shift = record_.adjustment->shift;
        adjustment.corrected_m = record_.adjustment->corrected_m;
    }
    record_.adjustment = std::move(adjustment);
    const bool declined = result->verdict == mapping::AdjustmentVerdict::Declined;
    notices_.say(Severity::Note, Topic::Adjustment,
                 (declined ? "The map was not corrected. " : "The map was corrected. ") + result->reason +
                     (record_.adjustment->shift ? shiftWords(*record_.adjustment->shift) : ""));
    worthSaving();
    return true;
}

void ScanBook::finishAdjustment() {
    beginAdjustment();
    while (adjustPart()) {
    }
}

mapping::HeightMap ScanBook::emptyMap() const {
    mapping::HeightMap map(cellSize_m());
    for (const auto& [index, tile] : earlier_tiles_)
        addCells(*tile, map);
    return map;
}

std::vector<CorrectedPoint> ScanBook::correctedPath() const {
    std::vector<CorrectedPoint> path;
    const auto& result = adjuster_.result();
    if (!result || result->correction.sorties.empty())
        return path;
    const auto& scans = mapper_.store().scans();
    for (const mapping::KeptScan& scan : scans) {
        const Vec3& at_m = scan.scanner_in_map.position_m;
        const bool is_garbled = !at_m.allFinite() || at_m.cwiseAbs().maxCoeff() > farthest_m;
        if (is_garbled || (!path.empty() && (at_m - path.back().estimated_m).norm() < cellSize_m()))
            continue;
        const mapping::PathKnot knot = result->correction.at(scan.sortie, scan.time);
        path.push_back({scan.time - scans.front().time, at_m, at_m - knot.error_m, knot.sigma_m});
    }
    return path;
}

void ScanBook::describeAdjustment(ScanRecord& copy) const {
    const auto& result = adjuster_.result();
    if (!copy.adjustment || !result || result->correction.sorties.empty())
        return;
    copy.adjustment->path = correctedPath();
    copy.adjustment->deviation = mapping::deviationOf(copy.raster, mapper_.map(), mapper_.store(), result->correction);
}

std::shared_ptr<const std::vector<mapping::KeptScan>> ScanBook::placedScans() const {
    const mapping::ScanStore& store = mapper_.store();
    if (store.overfull() || (store.scans().empty() && !record_.scans))
        return nullptr;
    auto scans = std::make_shared<std::vector<mapping::KeptScan>>();
    if (record_.scans)
        *scans = *record_.scans;
    for (const mapping::KeptScan& scan : store.scans()) {
        scans->push_back(scan);
        scans->back().scanner_in_map = adjuster_.correction().corrected(scan);
    }
    return scans;
}

ScanRecord ScanBook::snapshot(bool with_scans) const {
    ScanRecord copy = record_;
    copy.scans = with_scans ? placedScans() : nullptr;
    copy.raster.cell_size_m = cellSize_m();
    copy.far_rasters = mapping::rastersOf(mapper_.map());
    if (!copy.far_rasters.empty()) {
        copy.raster = std::move(copy.far_rasters.front());
        copy.far_rasters.erase(copy.far_rasters.begin());
    }
    describeAdjustment(copy);
    copy.cells_left_out = mapper_.map().knownCellCount() - knownCellCount(copy);
    return copy;
}

} // namespace usar::mission
