#include "core/sim/faults/wind.h"

#include <algorithm>
#include <cmath>

namespace usar::sim {

namespace {

constexpr double scale_m = 68.0;
constexpr double slowest_m_s = 3.0; // Gusts pass at least this fast, even in still air.

} // namespace

Wind::Wind(const WindParameters& parameters, Random random)
    : parameters_(parameters)
    , random_(random)
    , correlation_(scale_m / std::max(slowest_m_s, parameters.mean_in_map_m_s.norm())) {
    for (double& component : gust_m_s_)
        component = gaussian(random_, 1.0); // As if the wind had always blown.
    gust_m_s_ = gust_m_s_.cwiseProduct(Vec3(1.0, 1.0, 0.5)) * parameters_.gust_m_s;
}

Vec3 Wind::step(Seconds dt) {
    const double kept = std::exp(-dt / correlation_);
    const double fresh_m_s = std::sqrt(1.0 - kept * kept) * parameters_.gust_m_s;
    for (int axis = 0; axis < 3; ++axis)
        gust_m_s_[axis] = kept * gust_m_s_[axis] + gaussian(random_, 1.0) * fresh_m_s * (axis == 2 ? 0.5 : 1.0);
    return parameters_.mean_in_map_m_s + gust_m_s_;
}

} // namespace usar::sim
