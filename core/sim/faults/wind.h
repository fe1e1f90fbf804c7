// Moving air: a mean and gusts about it.
#pragma once

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/base/random.h"

namespace usar::sim {

struct WindParameters {
    Vec3 mean_in_map_m_s = Vec3::Zero();
    double gust_m_s = 0.0; ///< standard deviation along each horizontal axis; half of it upright
};

/// Gusts are a first-order Gauss-Markov process, the longitudinal form of Dryden's spectrum. Its correlation time is
/// length scale over mean speed; MIL-F-8785C (low altitude, 10 m above ground) gives a scale of 68 m.
class Wind {
public:
    Wind(const WindParameters& parameters, Random random);

    /// The air's velocity, map frame, for the next `dt`.
    Vec3 step(Seconds dt);

private:
    WindParameters parameters_;
    Random random_;
    Seconds correlation_;
    Vec3 gust_m_s_;
};

} // namespace usar::sim
