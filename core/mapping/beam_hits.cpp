#include "core/mapping/beam_hits.h"

#include <cmath>
#include <limits>

#include "core/mapping/hit.h"

namespace usar::mapping {

void HitFinder::aim(const Beams& beams) {
    const std::pair directions(beams.resolution_rad, beams.fov_rad);
    if (directions == directions_ && rays_.size() == beams.ranges_m.size())
        return;
    directions_ = directions;
    rays_.clear();
    for (std::size_t k = 0; k < beams.ranges_m.size(); ++k)
        rays_.emplace_back(std::cos(beams.angle_rad(k)), std::sin(beams.angle_rad(k)));
}

void HitFinder::find(const Beams& beams, const Pose& scanner_in_map, std::vector<Vec3>& hits_m) {
    aim(beams);
    const Eigen::Matrix3d rotation = scanner_in_map.rotation().toRotationMatrix();
    const bool placed = rotation.allFinite() && scanner_in_map.position_m.allFinite();
    hits_m.assign(beams.ranges_m.size(), Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
    for (std::size_t k = 0; placed && k < hits_m.size(); ++k) {
        const double range_m = beams.ranges_m[k];
        if (!(range_m > 0.0 && isHit(range_m, beams.maximum_m)))
            continue;
        hits_m[k] = scanner_in_map.position_m + rotation.leftCols<2>() * (range_m * rays_[k]);
    }
}

} // namespace usar::mapping
