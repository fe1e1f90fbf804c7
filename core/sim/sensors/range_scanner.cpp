#include "core/sim/sensors/range_scanner.h"

#include <cmath>
#include <utility>

namespace usar::sim {

RangeScanner::RangeScanner(RangeScannerParameters parameters, Random random)
    : parameters_(std::move(parameters))
    , noise_(parameters_.sigma, random) {
    // The small slack keeps the last beam if the quotient misses a whole number only by rounding.
    const int last = static_cast<int>(std::floor(parameters_.fov_rad / parameters_.resolution_rad + 1e-6));
    for (int beam = 0; beam <= last; ++beam) {
        const double angle_rad = -parameters_.fov_rad / 2.0 + beam * parameters_.resolution_rad;
        directions_in_base_.push_back(parameters_.scanner_in_base.rotation() *
                                      Vec3(std::cos(angle_rad), std::sin(angle_rad), 0.0));
    }
}

protocol::RangeScan RangeScanner::measure(const Eigen::Isometry3d& base_in_map, const Rays& rays) {
    const Vec3 origin_m = base_in_map * parameters_.scanner_in_base.position_m;
    protocol::RangeScan scan{{}, parameters_.name, parameters_.resolution_rad, parameters_.fov_rad, {}};
    scan.ranges_m.reserve(directions_in_base_.size());
    for (const Vec3& direction : directions_in_base_) {
        const double range_m = rays.cast(origin_m, base_in_map.linear() * direction, parameters_.maximum_m);
        scan.ranges_m.push_back(noise_(range_m, parameters_.minimum_m, parameters_.maximum_m));
    }
    return scan;
}

} // namespace usar::sim
