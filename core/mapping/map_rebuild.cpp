#include "core/mapping/map_rebuild.h"

#include <algorithm>

namespace usar::mapping {

bool MapRebuild::step() {
    const std::size_t end = std::min(next_ + scans_per_step, store_->scans().size());
    for (; next_ < end; ++next_) {
        const KeptScan& scan = store_->scans()[next_];
        ScanIntegrator& integrator = integrators_[scan.scanner];
        if (!scan.continues)
            integrator.breakStrip();
        integrator.integrate(scan.beams(ranges_m_), correction_.corrected(scan), scan.line, map_);
    }
    return next_ < store_->scans().size();
}

} // namespace usar::mapping
