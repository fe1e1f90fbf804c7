#include "core/mapping/map_rebuild.h"

#include <algorithm>

namespace usar::mapping {

bool MapRebuild::step() {
    const std::deque<KeptScan>& scans = store_->scans();
    if (next_ < scans.size()) {
        const std::size_t end = std::min(next_ + scans_per_step, scans.size());
        for (; next_ < end; ++next_)
            write(scans[next_]);
        return true;
    }
    if (looked_ == 0)
        floors_.findEdges(map_);
    const std::size_t end = std::min(looked_ + scans_per_step, next_);
    for (; looked_ < end; ++looked_)
        floors_.look(scans[looked_].beams(ranges_m_), correction_.corrected(scans[looked_]));
    if (looked_ < next_)
        return true;
    floors_.settle(map_);
    return false;
}

void MapRebuild::write(const KeptScan& scan) {
    ScanIntegrator& integrator = integrators_[scan.scanner];
    if (!scan.continues)
        integrator.breakStrip();
    const Pose scanner_in_map = correction_.corrected(scan);
    integrator.integrate(scan.beams(ranges_m_), scanner_in_map, scan.line, map_);
    for (const Vec3& hit_m : integrator.lastHits())
        floors_.add(scanner_in_map.position_m, hit_m);
}

} // namespace usar::mapping
