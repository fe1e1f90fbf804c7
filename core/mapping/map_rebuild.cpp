#include "core/mapping/map_rebuild.h"

#include <algorithm>

namespace usar::mapping {

bool MapRebuild::step() {
    if (next_ == store_->scans().size()) {
        floors_.settle(map_);
        return false;
    }
    const std::size_t end = std::min(next_ + scans_per_step, store_->scans().size());
    for (; next_ < end; ++next_) {
        const KeptScan& scan = store_->scans()[next_];
        ScanIntegrator& integrator = integrators_[scan.scanner];
        if (!scan.continues)
            integrator.breakStrip();
        const Pose scanner_in_map = correction_.corrected(scan);
        integrator.integrate(scan.beams(ranges_m_), scanner_in_map, scan.line, map_);
        for (const Vec3& hit_m : integrator.lastHits())
            floors_.add(scanner_in_map.position_m, hit_m);
    }
    return true;
}

} // namespace usar::mapping
