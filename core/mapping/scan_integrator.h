// Writes scans into a height map, filling between beams and between scans.
#pragma once

#include <span>
#include <vector>

#include "core/base/cause.h"
#include "core/base/geometry.h"
#include "core/mapping/height_map.h"

namespace usar::mapping {

/// A scan as geometry: beam k leaves the scanner at -fov/2 + k * resolution (counter-clockwise positive, about the
/// scanner's z axis, 0 = its x axis). Ranges at or beyond `maximum_m`, not positive, or NaN, hit nothing.
struct Beams {
    std::span<const double> ranges_m;
    double resolution_rad = 0.0;
    double fov_rad = 0.0;
    double maximum_m = 20.0;
};

/// Thesis 4.2: sparse data is made coherent by the average of two consecutive figures, between neighbouring beams and
/// between consecutive scans, subdivided until there is a value for every cell: linear between the two figures, and
/// their plain average in the cell half way. Two figures more than `gap_limit_m` apart over ground, or in height (a
/// trunk, a crown, a house), are not joined. Coarse cells stretch the limit over ground to two cells; 1.5 m holds all
/// beams of a level scan at 6 m together, up to the 20 m range (0.42 m apart 60 degrees off nadir, 1.1 m at 72).
/// Owned and called by one session.
class ScanIntegrator {
public:
    explicit ScanIntegrator(double gap_limit_m = 1.5);

    /// A pose that is not finite hits nothing and ends the strip.
    void integrate(const Beams& beams, const Pose& scanner_in_map, LineNumber line, HeightMap& map);
    /// The next scan does not continue the last one (transit, landing, another lane).
    void breakStrip();

    /// Points hit by the last scan, in beam order; NaN where a beam hit nothing.
    const std::vector<Vec3>& lastHits() const { return hits_; }

private:
    double gap_limit_m_;
    std::vector<Vec3> hits_;
    std::vector<Vec3> previous_hits_;
    bool strip_broken_ = true;
};

} // namespace usar::mapping
