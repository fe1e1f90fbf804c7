#include "core/sim/sensors/sonar.h"

#include <cmath>
#include <utility>

namespace usar::sim {

namespace {

std::vector<Vec3> coneOfRays(const SonarParameters& parameters) {
    std::vector<Vec3> directions{Vec3::UnitX()};
    for (int cone = 1; cone <= parameters.cones; ++cone) {
        const double off_axis_rad = parameters.beam_rad / 2.0 * cone / parameters.cones;
        for (int ray = 0; ray < parameters.rays_per_cone; ++ray) {
            const double around_rad = 2.0 * pi * ray / parameters.rays_per_cone;
            directions.emplace_back(std::cos(off_axis_rad), std::sin(off_axis_rad) * std::cos(around_rad),
                                    std::sin(off_axis_rad) * std::sin(around_rad));
        }
    }
    return directions;
}

} // namespace

Sonar::Sonar(SonarParameters parameters, Random random)
    : parameters_(std::move(parameters))
    , directions_in_base_(coneOfRays(parameters_))
    , noise_(parameters_.sigma, random) {
    for (Vec3& direction : directions_in_base_)
        direction = parameters_.sonar_in_base.rotation() * direction;
}

protocol::NamedRange Sonar::measure(const Eigen::Isometry3d& base_in_map, const Rays& rays) {
    const Vec3 origin_m = base_in_map * parameters_.sonar_in_base.position_m;
    directions_in_map_.clear();
    for (const Vec3& direction : directions_in_base_)
        directions_in_map_.emplace_back(base_in_map.linear() * direction);
    const double nearest_m = rays.castNearest(origin_m, directions_in_map_, parameters_.maximum_m);
    return {parameters_.name, noise_(nearest_m, parameters_.minimum_m, parameters_.maximum_m)};
}

} // namespace usar::sim
