#include "core/sim/radio.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace usar::sim {

double strengthOver(double distance_m, int obstacles, const RadioParameters& parameters) {
    const double far_m = std::max(distance_m, parameters.nearest_m);
    return parameters.reference_dbm - 10.0 * parameters.exponent * std::log10(far_m / parameters.reference_m) -
           std::min(obstacles, parameters.most_obstacles) * parameters.obstacle_db;
}

int obstaclesBetween(const RayCaster& still, const Vec3& a_in_map_m, const Vec3& b_in_map_m,
                     const RadioParameters& parameters) {
    Vec3 from_m = a_in_map_m;
    Vec3 to_m = b_in_map_m;
    if (std::ranges::lexicographical_compare(to_m, from_m)) // Samples fall on the same points in both directions.
        std::swap(from_m, to_m);
    const double length_m = (to_m - from_m).norm();
    if (!(length_m > 0.0) || !std::isfinite(length_m))
        return 0;
    const Vec3 direction = (to_m - from_m) / length_m;
    // Distance from a point on the line to the next solid thing; 0 inside one.
    const auto free_m = [&](double at_m) { return still.cast(from_m + at_m * direction, direction, length_m - at_m); };
    int obstacles = 0;
    double at_m = 0.0;
    while (obstacles < parameters.most_obstacles) {
        at_m += free_m(at_m);
        if (at_m >= length_m)
            break;
        ++obstacles;
        // A ray tells where it enters a solid, not where it leaves it, so test at each step whether it is out again.
        double entered_m = at_m;
        do {
            at_m += parameters.sample_m;
            if (at_m - entered_m >= parameters.solid_m) {
                ++obstacles;
                entered_m = at_m;
            }
        } while (at_m < length_m && obstacles < parameters.most_obstacles && free_m(at_m) == 0.0);
    }
    return std::min(obstacles, parameters.most_obstacles);
}

} // namespace usar::sim
