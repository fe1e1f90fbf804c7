#include "core/sim/robots/air_robot_parameters.h"

#include <algorithm>
#include <cmath>

namespace usar::sim {

namespace {

constexpr double pod_bottom_m = -0.10;
constexpr double leg_top_m = -0.03;

BodyPart part(const Shape& shape, const Vec3& center_m) {
    return {shape, Pose{center_m}};
}

} // namespace

AirRobotParameters airRobotParametersOf(const RobotModel& model) {
    AirRobotParameters p{.mass_kg = model.mass_kg(), .inertia_kg_m2 = model.body.base.inertia_kg_m2};
    double rotor_lag_s = p.rotor_lag.count();
    setFigures(model.drive.numbers, {{"rotor_lag", &rotor_lag_s},
                                     {"rotor_span", &p.rotor_span_m},
                                     {"rotor_radius", &p.rotor_radius_m},
                                     {"thrust_limit", &p.rotor_limit_n},
                                     {"rotor_drag", &p.rotor_drag_m},
                                     {"drag", &p.drag_kg_m},
                                     {"spin_drag", &p.spin_drag_n_m_s},
                                     {"forward_limit", &p.forward_limit_m_s},
                                     {"sideways_limit", &p.sideways_limit_m_s},
                                     {"climb_limit", &p.climb_limit_m_s},
                                     {"yaw_rate_limit", &p.yaw_rate_limit_rad_s},
                                     {"tilt_limit", &p.tilt_limit_rad},
                                     {"tilt_rate_limit", &p.tilt_rate_limit_rad_s},
                                     {"ring_height", &p.ring_height_m},
                                     {"pod_width", &p.pod_size_m.x()},
                                     {"breaking_impulse", &p.breaking_impulse_n_s},
                                     {"safe_touchdown", &p.safe_touchdown_m_s}});
    p.rotor_lag = Seconds{rotor_lag_s};
    return p;
}

std::array<Vec3, 4> rotorCenters(const AirRobotParameters& parameters) {
    const double l = parameters.rotor_span_m;
    return {Vec3(l, l, 0.01), Vec3(l, -l, 0.01), Vec3(-l, -l, 0.01), Vec3(-l, l, 0.01)};
}

BodyDescription bodyOf(const AirRobotParameters& parameters) {
    BodyDescription body{parameters.mass_kg, parameters.inertia_kg_m2, 0.9, {}};
    body.parts.push_back(part(CylinderShape{parameters.ring_radius_m, parameters.ring_height_m}, Vec3::Zero()));
    body.parts.push_back(
        part(BoxShape{parameters.pod_size_m}, {0.0, 0.0, pod_bottom_m + parameters.pod_size_m.z() / 2.0}));
    const double low_m = parameters.leg_tip_z_m + parameters.leg_radius_m;
    for (const Vec3& rotor_m : rotorCenters(parameters)) {
        const Vec2 foot_m = rotor_m.head<2>() / parameters.rotor_span_m * parameters.leg_span_m;
        body.parts.push_back(part(CapsuleShape{parameters.leg_radius_m, leg_top_m - low_m},
                                  {foot_m.x(), foot_m.y(), (leg_top_m + low_m) / 2.0}));
    }
    return body;
}

AirRobotPart partAt(const AirRobotParameters& parameters, const Vec3& point_in_body_m) {
    const bool in_disc_plane = std::abs(point_in_body_m.z()) < parameters.ring_height_m / 2.0 + 0.01;
    if (!in_disc_plane) {
        const double from_axis_m = point_in_body_m.head<2>().cwiseAbs().maxCoeff();
        return from_axis_m > parameters.pod_size_m.x() / 2.0 + 0.02 ? AirRobotPart::Gear : AirRobotPart::Belly;
    }
    const auto rotors = rotorCenters(parameters);
    const bool in_disc = std::any_of(rotors.begin(), rotors.end(), [&](const Vec3& rotor_m) {
        return (point_in_body_m - rotor_m).head<2>().norm() < parameters.rotor_radius_m;
    });
    return in_disc ? AirRobotPart::RotorDisc : AirRobotPart::Guard;
}

} // namespace usar::sim
