#include "core/mission/scan_mapper.h"

#include <algorithm>

#include "core/protocol/segments.h"

namespace usar::mission {

void ScanMapper::takeScan(const protocol::RangeScan& scan, LineNumber line) {
    ++scans_taken_;
    Shelved& place = shelf_[scans_taken_ % shelf_size];
    place.scan = scan;
    place.line = line;
    place.ordinal = scans_taken_;
}

void ScanMapper::takeConfiguration(const protocol::ConfigurationInfo& configuration) {
    if (!protocol::sameWord(configuration.type, "RangeScanner"))
        return;
    for (const protocol::ConfiguredItem& item : configuration.items)
        if (const auto maximum_m = item.number("MaxRange"); maximum_m && *maximum_m > 0.0)
            maximum_m_[item.name] = *maximum_m;
}

double ScanMapper::maximumOf(const std::string& scanner) const {
    const auto found = maximum_m_.find(scanner);
    return found == maximum_m_.end() ? mapping::Beams{}.maximum_m : found->second;
}

bool ScanMapper::place(const agent::ScanPlacement& placement) {
    const auto shelved = std::ranges::find(shelf_, placement.scan_line, &Shelved::line);
    if (shelved == shelf_.end() || shelved->ordinal == 0)
        return false;
    if (shelved->ordinal != last_placed_ + 1)
        integrator_.breakStrip();
    last_placed_ = shelved->ordinal;
    const protocol::RangeScan& scan = shelved->scan;
    integrator_.integrate({.ranges_m = scan.ranges_m,
                           .resolution_rad = scan.step_rad(),
                           .fov_rad = scan.fov_rad,
                           .maximum_m = maximumOf(scan.name)},
                          placement.scanner_in_map, placement.scan_line, map_);
    return true;
}

void ScanMapper::forgetScans() {
    shelf_ = {};
    scans_taken_ = 0;
    last_placed_ = 0;
    maximum_m_.clear();
    integrator_.breakStrip();
}

void ScanMapper::clearMap() {
    map_ = mapping::HeightMap(map_.cellSize_m());
    integrator_.breakStrip();
}

} // namespace usar::mission
