// Writes scans into a height map and fills the cells between beams and between scans.
#pragma once

#include <vector>

#include "core/base/cause.h"
#include "core/base/geometry.h"
#include "core/mapping/beam_hits.h"
#include "core/mapping/height_map.h"

namespace usar::mapping {

/// Integrates scans as in thesis 4.2: sparse data is made coherent by averaging two consecutive values, between
/// neighboring beams and between consecutive scans, repeatedly until there is a value for every cell. This amounts to
/// linear interpolation between the two values. Two hits that are more than `gap_limit_m` apart horizontally, or in
/// height (a trunk, a treetop, a house), are not joined. With coarse cells the horizontal limit is two cells. A limit
/// of 1.5 m joins all beams of a level scan at an altitude of 6 m, up to the range of 20 m (hits are 0.42 m apart at 60
/// degrees off nadir, 1.1 m at 72). Each integrator is owned and called by one session.
class ScanIntegrator {
public:
    explicit ScanIntegrator(double gap_limit_m = 1.5) : gap_limit_m_(gap_limit_m) {}

    /// Writes the hits of one scan and fills the gaps. With a pose that is not finite, all beams are misses, so that
    /// the next scan is not joined to this one either. `line` is the number of the scan's info line.
    void integrate(const Beams& beams, const Pose& scanner_in_map, LineNumber line, HeightMap& map);
    /// Call it if the next scan does not continue the last one (transit, landing, another lane).
    void breakStrip() { strip_broken_ = true; }

    /// Points hit by the last scan, in the map frame and in beam order; NaN for misses.
    const std::vector<Vec3>& lastHits() const { return hits_; }

private:
    double gap_limit_m_;
    HitFinder finder_;
    std::vector<Vec3> hits_;
    std::vector<Vec3> previous_hits_;
    bool strip_broken_ = true;
};

} // namespace usar::mapping
