// Moving air: a mean wind with gusts.
#pragma once

#include "core/base/clock.h"
#include "core/base/geometry.h"
#include "core/base/random.h"

namespace usar::sim {

struct WindParameters {
    Vec3 mean_in_map_m_s = Vec3::Zero(); ///< points to where it blows
    double gust_m_s = 0.0;               ///< standard deviation along each horizontal axis; half of it vertically
};

/// Gusts are a first-order Gauss-Markov process, the longitudinal form of Dryden's spectrum. Its correlation time is
/// the length scale divided by the mean speed, which counts as at least 3 m/s; MIL-F-8785C (low altitude, 10 m above
/// ground) gives a scale of 68 m.
class Wind {
public:
    /// Starts with random gusts, as if the wind had always blown.
    Wind(const WindParameters& parameters, Random random);

    /// Moves on by `dt` and returns the air's velocity during it, map frame.
    Vec3 step(Seconds dt);

private:
    WindParameters parameters_;
    Random random_;
    Seconds correlation_;
    Vec3 gust_m_s_;
};

} // namespace usar::sim
