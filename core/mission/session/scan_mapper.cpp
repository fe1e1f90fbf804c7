#include "core/mission/session/scan_mapper.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/protocol/info/configurations.h"

namespace usar::mission {

namespace {

/// The rounding of the wire on both axes, twice.
constexpr double set_there_m = 0.03;
constexpr double confirmed_there_m = 0.5;
/// A behavior may be some readings behind.
constexpr std::size_t truths_kept = 8;
constexpr double same_m = 1e-6;
/// A reading may be late or refused now and then also in a flight by ground truth.
constexpr int surely_unlike = 5;
/// A server that sets the INS has done so after this many estimates, which are a few seconds.
constexpr int longest_setting = 25;

} // namespace

ScanMapper::Scanner& ScanMapper::scannerNamed(const std::string& name) {
    const auto found = scanners_.find(name);
    if (found != scanners_.end())
        return found->second;
    const auto number = static_cast<std::uint32_t>(scanners_.size());
    const auto [made, is_new] = scanners_.try_emplace(number < scanner_limit ? name : std::string());
    if (is_new)
        made->second.number = number;
    return made->second;
}

void ScanMapper::takeScan(const protocol::RangeScan& scan, LineNumber line) {
    Scanner& scanner = scannerNamed(scan.name);
    ++scanner.scans_taken;
    Shelved& place = scanner.shelf[scanner.scans_taken % shelf_size];
    place.scan = scan;
    place.line = line;
    place.ordinal = scanner.scans_taken;
}

void ScanMapper::takeConfiguration(const protocol::ConfigurationInfo& configuration) {
    for (const protocol::SensorConfiguration& sensor : protocol::sensorConfigurationsOf(configuration))
        if (sensor.fov_rad && sensor.range_max_m && *sensor.range_max_m > 0.0) // A scanner of any type.
            maximum_m_[sensor.name] = *sensor.range_max_m;
}

void ScanMapper::takeGeometry(const protocol::GeometryInfo& geometry) {
    for (const protocol::MountedItem& item : geometry.items)
        if (mounts_.size() < mount_limit && sameWord(item.mount, "HARD"))
            mounts_[item.name] = item.item_in_mount;
}

void ScanMapper::takeSent(const protocol::Command& command) {
    const auto* set = std::get_if<protocol::SetInsPose>(&command);
    if (!set)
        return;
    set_in_map_m_ = set->base_in_map.position_m;
    estimates_since_set_ = 0;
    set_confirmed_ = false;
}

void ScanMapper::takeResponse(const protocol::Response& response) {
    set_confirmed_ = set_confirmed_ || (response.ok && sameWord(response.type, "INS"));
}

void ScanMapper::takeTruth(const protocol::GroundTruthReading& reading) {
    truths_m_.push_back(reading.base_in_map.position_m);
    if (truths_m_.size() > truths_kept)
        truths_m_.pop_front();
}

bool ScanMapper::takePose(const agent::PoseEstimate& estimate) {
    const Vec3& base_in_map_m = estimate.base_in_map.position_m;
    const bool is_true =
        std::ranges::any_of(truths_m_, [&](const Vec3& true_m) { return (true_m - base_in_map_m).norm() < same_m; });
    unlike_ = is_true ? 0 : unlike_ + 1;
    errs_ = errs_ || unlike_ >= surely_unlike;
    store_.setExact(!errs_);
    const double there_m = set_confirmed_ ? confirmed_there_m : set_there_m;
    const bool set = set_in_map_m_ && (base_in_map_m - *set_in_map_m_).norm() < there_m;
    if (set) {
        level_flight_.insWasSet();
        error_ = {};
        store_.insWasSet(last_base_in_map_m_.value_or(*set_in_map_m_), *set_in_map_m_);
    }
    if (set || ++estimates_since_set_ > longest_setting)
        set_in_map_m_.reset();
    last_base_in_map_m_ = base_in_map_m;
    level_flight_.take(estimate.time, estimate.base_in_map);
    store_.move(estimate.time, base_in_map_m);
    return set;
}

Pose ScanMapper::leveled(const std::string& scanner, const Pose& scanner_in_map) const {
    const auto mount = mounts_.find(scanner);
    if (!improves_ || !errs_ || mount == mounts_.end())
        return scanner_in_map;
    return level_flight_.corrected(scanner_in_map * inverse(mount->second)) * mount->second;
}

double ScanMapper::maximumOf(const std::string& scanner) const {
    const auto found = maximum_m_.find(scanner);
    return found == maximum_m_.end() ? mapping::Beams{}.maximum_m : found->second;
}

bool ScanMapper::place(const agent::ScanPlacement& placement) {
    for (auto& [name, scanner] : scanners_) {
        const auto shelved = std::ranges::find(scanner.shelf, placement.scan_line, &Shelved::line);
        if (shelved == scanner.shelf.end() || shelved->ordinal == 0)
            continue;
        const bool continues = scanner.last_placed > 0 && shelved->ordinal == scanner.last_placed + 1;
        if (!continues)
            scanner.integrator.breakStrip();
        scanner.last_placed = shelved->ordinal;
        const protocol::RangeScan& scan = shelved->scan;
        const mapping::Beams beams{.ranges_m = scan.ranges_m,
                                   .resolution_rad = scan.step_rad(),
                                   .fov_rad = scan.fov_rad,
                                   .maximum_m = maximumOf(scan.name)};
        const Pose scanner_in_map = leveled(scan.name, placement.scanner_in_map);
        scanner.integrator.integrate(beams, error_.corrected(scanner_in_map), placement.scan_line, map_);
        if (improves_ || keeps_)
            store_.keep({.scanner_in_map = scanner_in_map,
                         .line = placement.scan_line,
                         .scanner = scanner.number,
                         .continues = continues,
                         .ranges_m = {scan.ranges_m.begin(), scan.ranges_m.end()},
                         .resolution_rad = beams.resolution_rad,
                         .fov_rad = beams.fov_rad,
                         .maximum_m = beams.maximum_m});
        last_hits_ = scanner.integrator.lastHits();
        return true;
    }
    return false;
}

void ScanMapper::forgetScans() {
    scanners_.clear();
    maximum_m_.clear();
    mounts_.clear();
    level_flight_ = {};
    error_ = {};
    truths_m_.clear();
    store_.interrupt();
}

void ScanMapper::clearMap(std::optional<double> cell_size_m) {
    store_.clear();
    errs_ = false;
    unlike_ = 0;
    map_ = mapping::HeightMap(cell_size_m.value_or(map_.cellSize_m()));
    for (auto& [name, scanner] : scanners_)
        scanner.integrator.breakStrip();
}

void ScanMapper::replaceMap(mapping::HeightMap map) {
    for (const mapping::GridIndex& tile : map_.tileIndices())
        map.addTile(tile);
    map_ = std::move(map);
}

} // namespace usar::mission
