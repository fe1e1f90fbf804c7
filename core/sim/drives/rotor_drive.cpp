#include "core/sim/drives/rotor_drive.h"

#include <algorithm>
#include <limits>

namespace usar::sim {

AirRobotParameters airRobotParametersOf(const RobotModel& model) {
    AirRobotParameters p;
    const auto take = [&](const char* key, double& figure) { figure = numberOr(model.drive.numbers, key, figure); };
    p.mass_kg = model.mass_kg();
    p.inertia_kg_m2 = model.body.base.inertia_kg_m2;
    p.dimensions_m = model.dimensions_m;
    take("rotor_span", p.rotor_span_m);
    take("rotor_radius", p.rotor_radius_m);
    take("thrust_limit", p.rotor_limit_n);
    p.rotor_lag = Seconds{numberOr(model.drive.numbers, "rotor_lag", p.rotor_lag.count())};
    take("rotor_drag", p.rotor_drag_m);
    take("drag", p.drag_kg_m);
    take("spin_drag", p.spin_drag_n_m_s);
    take("forward_limit", p.forward_limit_m_s);
    take("sideways_limit", p.sideways_limit_m_s);
    take("climb_limit", p.climb_limit_m_s);
    take("yaw_rate_limit", p.yaw_rate_limit_rad_s);
    take("tilt_limit", p.tilt_limit_rad);
    take("tilt_rate_limit", p.tilt_rate_limit_rad_s);
    take("ring_height", p.ring_height_m);
    take("pod_width", p.pod_size_m.x());
    take("breaking_impulse", p.breaking_impulse_n_s);
    take("safe_touchdown", p.safe_touchdown_m_s);
    return p;
}

RotorDrive::RotorDrive(const RobotModel& model, Physics& physics, BodyId body, const DriveBirth& birth)
    : body_(physics, body, {birth.base_in_map, birth.near_ground, Seconds{std::numeric_limits<double>::infinity()}},
            airRobotParametersOf(model)) {}

bool RotorDrive::obey(const protocol::Command& command) {
    const auto* const drive = std::get_if<protocol::AerialDrive>(&command);
    if (drive)
        body_.drive(*drive);
    return drive != nullptr;
}

bool RotorDrive::weakenRotor(int rotor, double share) {
    body_.rotors().weaken(static_cast<std::size_t>(std::clamp(rotor, 1, 4) - 1), share);
    return true;
}

void RotorDrive::addTo(std::vector<protocol::Setting>& settings) const {
    const AirRobotParameters& p = body_.parameters();
    settings.insert(settings.end(), {{"MaxLateralVelocity", "", p.sideways_limit_m_s},
                                     {"MaxLinearVelocity", "", p.forward_limit_m_s},
                                     {"MaxAltitudeVelocity", "", p.climb_limit_m_s},
                                     {"MaxRotationalVelocity", "", p.yaw_rate_limit_rad_s}});
}

} // namespace usar::sim
