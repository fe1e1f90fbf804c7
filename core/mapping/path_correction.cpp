#include "core/mapping/path_correction.h"

#include <algorithm>

namespace usar::mapping {

PathKnot PathCorrection::at(std::size_t sortie, Seconds time) const {
    if (sortie >= sorties.size() || sorties[sortie].empty())
        return {.time = time};
    const std::vector<PathKnot>& knots = sorties[sortie];
    const auto after = std::ranges::lower_bound(knots, time, {}, &PathKnot::time);
    if (after == knots.begin() || after == knots.end()) {
        PathKnot nearest = after == knots.end() ? knots.back() : knots.front();
        nearest.time = time;
        return nearest;
    }
    const PathKnot& before = *std::prev(after);
    const double part = (time - before.time) / (after->time - before.time);
    return {time, before.error_m + part * (after->error_m - before.error_m),
            before.sigma_m + part * (after->sigma_m - before.sigma_m),
            before.yaw_error_rad + part * (after->yaw_error_rad - before.yaw_error_rad)};
}

Pose PathCorrection::corrected(const KeptScan& scan) const {
    Pose pose = scan.scanner_in_map;
    const PathKnot knot = at(scan.sortie, scan.time);
    pose.position_m -= knot.error_m;
    pose.yaw_rad -= knot.yaw_error_rad;
    return pose;
}

} // namespace usar::mapping
