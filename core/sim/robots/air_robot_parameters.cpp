#include "core/sim/robots/air_robot_parameters.h"

#include <algorithm>
#include <cmath>

namespace usar::sim {

std::array<Vec3, 4> rotorCenters(const AirRobotParameters& parameters) {
    const double l = parameters.rotor_span_m;
    return {Vec3(l, l, 0.01), Vec3(l, -l, 0.01), Vec3(-l, -l, 0.01), Vec3(-l, l, 0.01)};
}

AirRobotPart partAt(const AirRobotParameters& parameters, const Vec3& point_in_body_m) {
    const bool in_disc_plane = std::abs(point_in_body_m.z()) < parameters.ring_height_m / 2.0 + 0.01;
    if (!in_disc_plane) {
        const double from_axis_m = point_in_body_m.head<2>().cwiseAbs().maxCoeff();
        return from_axis_m > parameters.pod_width_m / 2.0 + 0.02 ? AirRobotPart::Gear : AirRobotPart::Belly;
    }
    const auto rotors = rotorCenters(parameters);
    const bool in_disc = std::any_of(rotors.begin(), rotors.end(), [&](const Vec3& rotor_m) {
        return (point_in_body_m - rotor_m).head<2>().norm() < parameters.rotor_radius_m;
    });
    return in_disc ? AirRobotPart::RotorDisc : AirRobotPart::Guard;
}

} // namespace usar::sim
