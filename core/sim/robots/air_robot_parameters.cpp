#include "core/sim/robots/air_robot_parameters.h"

#include <algorithm>
#include <cmath>

namespace usar::sim {

namespace {

constexpr double rotor_z_m = 0.01;

} // namespace

std::array<Vec3, 4> rotorCenters(const AirRobotParameters& parameters) {
    const double l = parameters.rotor_span_m;
    return {Vec3(l, l, rotor_z_m), Vec3(l, -l, rotor_z_m), Vec3(-l, -l, rotor_z_m), Vec3(-l, l, rotor_z_m)};
}

std::array<BodyBox, 24> ringAsFarAsRotors(const AirRobotParameters& parameters, bool above) {
    std::array<BodyBox, 24> boxes;
    const double inner_m = std::sqrt(2.0) * parameters.rotor_span_m + parameters.rotor_radius_m;
    const double outer_m = parameters.ring_radius_m;
    const double side_m = 2.0 * outer_m * std::tan(pi / static_cast<double>(boxes.size()));
    const double edge_m = parameters.ring_height_m / 2.0;
    const double end_m = above ? 2.0 * edge_m - rotor_z_m : -2.0 * edge_m - rotor_z_m;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const double yaw_rad = 2.0 * pi * static_cast<double>(i) / static_cast<double>(boxes.size());
        const double middle_m = (inner_m + outer_m) / 2.0;
        boxes[i] = {{middle_m * std::cos(yaw_rad), middle_m * std::sin(yaw_rad), end_m / 2.0},
                    yaw_rad,
                    {outer_m - inner_m, side_m, std::abs(end_m)}};
    }
    return boxes;
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
