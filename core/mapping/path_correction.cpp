#include "core/mapping/path_correction.h"

#include <algorithm>

namespace usar::mapping {

Pose PathKnot::corrected(Pose in_map) const {
    in_map.position_m -= error_m;
    in_map.yaw_rad -= yaw_error_rad;
    return in_map;
}

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
    return at(scan.sortie, scan.time).corrected(scan.scanner_in_map);
}

} // namespace usar::mapping
