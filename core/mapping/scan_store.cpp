#include "core/mapping/scan_store.h"

#include <utility>

namespace usar::mapping {

namespace {

/// Between two connections; longer than what counts as seen at one time.
constexpr Seconds pause{60.0};

} // namespace

Beams KeptScan::beams(std::vector<double>& into_m) const {
    into_m.assign(ranges_m.begin(), ranges_m.end());
    return {.ranges_m = into_m, .resolution_rad = resolution_rad, .fov_rad = fov_rad, .maximum_m = maximum_m};
}

void ScanStore::move(Seconds now, const Vec3& base_in_map_m) {
    if (!base_in_map_m.allFinite())
        return;
    if (std::exchange(new_clock_, false) && !sorties_.empty())
        shift_ = sorties_.back().end + pause - now;
    const Seconds at = now + shift_;
    if (std::exchange(new_sortie_, false) || sorties_.empty()) {
        sorties_.push_back({.begin = at, .end = at});
        last_m_ = base_in_map_m;
    }
    Sortie& sortie = sorties_.back();
    if (at < sortie.end)
        return;
    sortie.end = at;
    sortie.walk_m2 += (base_in_map_m - *last_m_).squaredNorm();
    last_m_ = base_in_map_m;
}

void ScanStore::insWasSet(const Vec3& from_m, const Vec3& to_m) {
    if (!sorties_.empty() && !new_sortie_)
        sorties_.back().closing_error_m = from_m - to_m;
    new_sortie_ = true;
}

void ScanStore::interrupt() {
    new_clock_ = new_sortie_ = true;
}

void ScanStore::keep(KeptScan scan) {
    if (overfull_ || sorties_.empty() || new_sortie_)
        return;
    scan.time = sorties_.back().end;
    scan.sortie = static_cast<std::uint32_t>(sorties_.size() - 1);
    scan.walk_m2 = sorties_.back().walk_m2;
    bytes_ += sizeof(KeptScan) + scan.ranges_m.capacity() * sizeof(float);
    scans_.push_back(std::move(scan));
    if (bytes_ <= most_bytes)
        return;
    clear();
    overfull_ = true;
}

} // namespace usar::mapping
