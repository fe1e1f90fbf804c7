// Writes scans into a height map, filling between beams and between scans.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/cause.h"
#include "core/base/geometry.h"
#include "core/mapping/height_map.h"

namespace usar::mapping {

/// A scan as geometry: beam k leaves the scanner at -fov/2 + k * resolution (counter-clockwise positive, about the
/// scanner's z axis, 0 = its x axis). Ranges at or beyond `maximum_m`, or NaN, hit nothing.
struct Beams {
    std::span<const double> ranges_m;
    double resolution_rad = 0.0;
    double fov_rad = 0.0;
    double maximum_m = 20.0;
};

/// Thesis 4.2: sparse data is made coherent by the average of two consecutive figures, between neighbouring beams and
/// between consecutive scans, as long as they lie within `gap_limit_m` of each other.
class ScanIntegrator {
public:
    explicit ScanIntegrator(double gap_limit_m = 1.5);

    void integrate(const Beams& beams, const Pose& scanner_in_map, LineNumber line, HeightMap& map);
    /// The next scan does not continue the last one (transit, landing, another lane).
    void breakStrip();

    /// Points hit by the last scan, in beam order; NaN where a beam hit nothing.
    const std::vector<Vec3>& lastHits() const { return hits_; }

private:
    double gap_limit_m_;
    std::vector<Vec3> hits_;
    std::vector<Vec3> previous_hits_;
};

} // namespace usar::mapping
