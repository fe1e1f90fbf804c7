// One sonar: the nearest thing in a cone of rays. Model: robots-and-worlds.md 4.2.
#pragma once

#include <string>
#include <vector>

#include "core/protocol/sensors/sonar.h"
#include "core/sim/noise.h"
#include "core/sim/sensors/rays.h"

namespace usar::sim {

/// Here and below, the base is the link that carries the sonar. It looks along its x axis.
struct SonarParameters {
    std::string name;
    Pose sonar_in_base;
    double beam_rad = radians(15.0); ///< full angle
    double minimum_m = 0.1;
    double maximum_m = 5.0;
    int cones = 2; ///< gives 33 rays; the reference with 161 rays has 10
    int rays_per_cone = 16;
    double sigma = 0.001; ///< see RangeNoise
};

/// A central ray, and cones of rays whose half-angles grow evenly to half the beam. Oblique echoes count.
class Sonar {
public:
    Sonar(SonarParameters parameters, Random random);

    /// The nearest range with noise; the maximum on a miss.
    protocol::NamedRange measure(const Eigen::Isometry3d& base_in_map, const Rays& rays);
    const SonarParameters& parameters() const { return parameters_; }
    std::size_t rayCount() const { return directions_in_base_.size(); }

private:
    SonarParameters parameters_;
    std::vector<Vec3> directions_in_base_;
    std::vector<Vec3> directions_in_map_; ///< those of the last measurement; kept to reuse their memory
    RangeNoise noise_;
};

} // namespace usar::sim
