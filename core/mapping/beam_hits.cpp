#include "core/mapping/beam_hits.h"

#include <cmath>
#include <limits>

#include "core/mapping/hit.h"

namespace usar::mapping {

const std::vector<Vec2>& BeamDirections::of(double resolution_rad, double fov_rad, std::size_t count) {
    const std::pair geometry(resolution_rad, fov_rad);
    if (geometry == geometry_ && directions_.size() == count)
        return directions_;
    geometry_ = geometry;
    directions_.clear();
    const Beams beams{{}, resolution_rad, fov_rad};
    for (std::size_t k = 0; k < count; ++k)
        directions_.emplace_back(std::cos(beams.angle_rad(k)), std::sin(beams.angle_rad(k)));
    return directions_;
}

void HitFinder::find(const Beams& beams, const Pose& scanner_in_map, std::vector<Vec3>& hits_m) {
    const std::vector<Vec2>& rays = directions_.of(beams.resolution_rad, beams.fov_rad, beams.ranges_m.size());
    const Eigen::Matrix3d rotation = scanner_in_map.rotation().toRotationMatrix();
    const bool placed = rotation.allFinite() && scanner_in_map.position_m.allFinite();
    hits_m.assign(beams.ranges_m.size(), Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
    for (std::size_t k = 0; placed && k < hits_m.size(); ++k) {
        const double range_m = beams.ranges_m[k];
        if (!(range_m > 0.0 && isHit(range_m, beams.maximum_m)))
            continue;
        hits_m[k] = scanner_in_map.position_m + rotation.leftCols<2>() * (range_m * rays[k]);
    }
}

} // namespace usar::mapping
