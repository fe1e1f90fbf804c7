#include "core/sim/noise.h"

#include <algorithm>

namespace usar::sim {

double RangeNoise::operator()(double range_m, double minimum_m, double maximum_m) {
    if (range_m >= maximum_m)
        return maximum_m;
    const double factor = sigma_ > 0.0 ? 1.0 + gaussian(random_, sigma_) : 1.0;
    return std::clamp(range_m * factor, minimum_m, maximum_m);
}

} // namespace usar::sim
