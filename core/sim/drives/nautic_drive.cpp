#include "core/sim/drives/nautic_drive.h"

#include <algorithm>
#include <cmath>

namespace usar::sim {

namespace {

constexpr int slices = 9;
constexpr double propeller_lag_s = 0.3;

/// Share of a circle's area below a level that is `depth` radii above its center.
double circleUnder(double depth) {
    const double d = std::clamp(depth, -1.0, 1.0);
    return (std::acos(-d) + d * std::sqrt(1.0 - d * d)) / pi;
}

/// Drag against the motion, but no more than stops it within the step.
double dragOn(double speed, double coefficient, double inertia, double dt_s) {
    return -std::copysign(std::min(coefficient * speed * speed, inertia * std::abs(speed) / dt_s), speed);
}

double approach(double value, double wanted, double most) {
    return value + std::clamp(wanted - value, -most, most);
}

} // namespace

NauticDrive::NauticDrive(const RobotModel& model, Physics& physics, BodyId body, const World& world)
    : model_(model)
    , physics_(physics)
    , body_(body)
    , water_(world.water)
    , hull_{model.drive.numbers}
    , inertia_kg_m2_(model.body.base.inertia_kg_m2)
    , mass_kg_(model.mass_kg()) {
    if (water_ && hull_.volume_m3 <= 0.0)
        hull_.volume_m3 = mass_kg_ / water_->density_kg_m3;
}

bool NauticDrive::obey(const protocol::Command& command) {
    const auto* const drive = std::get_if<protocol::NauticDrive>(&command);
    if (!drive)
        return false;
    const bool percent = drive->normalized;
    takeTerm(drive->propeller_rad_s, hull_.propeller_limit_rad_s, percent, wanted_propeller_rad_s_);
    takeTerm(drive->rudder_rad, hull_.rudder_limit_rad, percent, wanted_rudder_rad_);
    takeTerm(drive->stern_plane_rad, hull_.stern_plane_limit_rad, percent, wanted_stern_plane_rad_);
    return true;
}

void NauticDrive::turnFins(double dt_s) {
    propeller_rad_s_ += (wanted_propeller_rad_s_ - propeller_rad_s_) * std::min(1.0, dt_s / propeller_lag_s);
    rudder_rad_ = approach(rudder_rad_, wanted_rudder_rad_, hull_.fin_rate_rad_s * dt_s);
    stern_plane_rad_ = approach(stern_plane_rad_, wanted_stern_plane_rad_, hull_.fin_rate_rad_s * dt_s);
}

/// Share of the hull that is under water. Adds the lift of that part to `buoyancy`.
double NauticDrive::submergedShare(const BodyState& state, Wrench& buoyancy) const {
    double share = 0.0;
    const Vec3 up_in_body = state.rotation.conjugate() * Vec3::UnitZ();
    for (int i = 0; i < slices; ++i) {
        const double x_m = hull_.length_m * ((i + 0.5) / slices - 0.5);
        const Vec3 slice_m = Vec3(x_m, 0.0, hull_.buoyancy_z_m) - model_.center_of_mass_in_base_m;
        const double depth_m = water_->surface_z_m - (state.position_m + state.rotation * slice_m).z();
        const double under = circleUnder(depth_m / hull_.radius_m) / slices;
        const Vec3 lift_n = water_->density_kg_m3 * hull_.volume_m3 * gravity_m_s2 * under * up_in_body;
        buoyancy.force_n += lift_n;
        buoyancy.torque_n_m += slice_m.cross(lift_n);
        share += under;
    }
    return share;
}

/// Weight of the whole robot, about the base's center of mass: links pull at their own places.
NauticDrive::Wrench NauticDrive::weight(const BodyState& state) const {
    const Vec3 down_in_body = state.rotation.conjugate() * -Vec3::UnitZ();
    Wrench weight{mass_kg_ * gravity_m_s2 * down_in_body};
    for (std::size_t i = 0; i < model_.body.links.size(); ++i) {
        const Vec3 link_m = state.rotation.conjugate() * (physics_.state(body_, i).position_m - state.position_m);
        weight.torque_n_m += link_m.cross(model_.body.links[i].body.mass_kg * gravity_m_s2 * down_in_body);
    }
    return weight;
}

NauticDrive::Wrench NauticDrive::drag(const Vec3& v, const Vec3& w, double share, double dt_s) const {
    return {.force_n = {dragOn(v.x(), share * hull_.surge_drag_kg_m, mass_kg_, dt_s),
                        dragOn(v.y(), share * hull_.cross_drag_kg_m, mass_kg_, dt_s),
                        dragOn(v.z(), share * hull_.cross_drag_kg_m, mass_kg_, dt_s)},
            .torque_n_m = {dragOn(w.x(), share * hull_.roll_drag_kg_m2, inertia_kg_m2_.x(), dt_s),
                           dragOn(w.y(), share * hull_.pitch_drag_kg_m2, inertia_kg_m2_.y(), dt_s),
                           dragOn(w.z(), share * hull_.yaw_drag_kg_m2, inertia_kg_m2_.z(), dt_s)}};
}

NauticDrive::Wrench NauticDrive::propulsion(double surge_m_s, double share) const {
    const double spin = propeller_rad_s_ / hull_.propeller_limit_rad_s;
    const double flow_m2_s2 = surge_m_s * std::abs(surge_m_s);
    Wrench push;
    push.force_n = {hull_.thrust_limit_n * spin * std::abs(spin), hull_.fin_lift_kg_m * flow_m2_s2 * rudder_rad_,
                    -hull_.fin_lift_kg_m * flow_m2_s2 * stern_plane_rad_};
    // In the base's frame, z up and y left, both a rising nose and a turn to the right are negative.
    push.torque_n_m = {0.0, -hull_.fin_moment_kg * flow_m2_s2 * stern_plane_rad_,
                       -hull_.fin_moment_kg * flow_m2_s2 * rudder_rad_};
    push.force_n *= share;
    push.torque_n_m *= share;
    return push;
}

void NauticDrive::beforeStep(Seconds dt) {
    turnFins(dt.count());
    if (!water_)
        return;
    const BodyState state = physics_.state(body_);
    const Vec3 velocity_m_s = state.rotation.conjugate() * state.velocity_m_s;
    const Vec3 rate_rad_s = state.rotation.conjugate() * state.rate_rad_s;
    Wrench sum;
    const double share = submergedShare(state, sum);
    if (share <= 0.0)
        return;
    const Wrench weight = this->weight(state);
    for (const Wrench& part :
         {drag(velocity_m_s, rate_rad_s, share, dt.count()), propulsion(velocity_m_s.x(), share)}) {
        sum.force_n += part.force_n;
        sum.torque_n_m += part.torque_n_m;
    }
    // Water that must be moved along makes the body harder to accelerate, which is the same as less force on the body
    // alone. The engine adds the weight itself, so it is taken out again.
    const Vec3 added_kg = share * Vec3(hull_.surge_added_mass_kg, hull_.cross_added_mass_kg, hull_.cross_added_mass_kg);
    const Vec3 added_kg_m2 = share * Vec3(0.0, hull_.turn_added_inertia_kg_m2, hull_.turn_added_inertia_kg_m2);
    const Vec3 moved = Vec3::Constant(mass_kg_).cwiseQuotient(Vec3::Constant(mass_kg_) + added_kg);
    const Vec3 turned = inertia_kg_m2_.cwiseQuotient(inertia_kg_m2_ + added_kg_m2);
    const Vec3 force_n = moved.cwiseProduct(sum.force_n + weight.force_n) - weight.force_n;
    const Vec3 torque_n_m = turned.cwiseProduct(sum.torque_n_m + weight.torque_n_m) - weight.torque_n_m;
    physics_.apply(body_, state.rotation * force_n, state.rotation * torque_n_m);
}

void NauticDrive::afterStep(Seconds dt) {
    collisions_.pass(dt);
    if (!physics_.contacts(body_).empty())
        collisions_.touch();
}

void NauticDrive::switchOff() {
    wanted_propeller_rad_s_ = 0.0;
}

bool NauticDrive::idle() const {
    return wanted_propeller_rad_s_ == 0.0;
}

void NauticDrive::addState(protocol::RobotState& state) const {
    state.joints.push_back({"SternPlaneAngle", stern_plane_rad_});
    state.joints.push_back({"RudderAngle", rudder_rad_});
}

/// The names of the limits are ours, because no source gives UT2004's (robots-and-worlds.md 2).
void NauticDrive::addSettings(std::vector<protocol::Setting>& settings) const {
    settings.insert(settings.end(), {{"MaxPropellerSpeed", "", hull_.propeller_limit_rad_s},
                                     {"MaxRudderAngle", "", hull_.rudder_limit_rad},
                                     {"MaxSternPlaneAngle", "", hull_.stern_plane_limit_rad}});
}

} // namespace usar::sim
