#include "core/sim/drives/rotor_drive.h"

#include <algorithm>

namespace usar::sim {

namespace {

constexpr double climb_wish_m_s = 0.05;
constexpr double sink_wish_m_s = -0.02;
constexpr double landing_itself_m_s = -0.3;
constexpr Seconds settling_time{2.0};
constexpr Seconds spooling_time{0.8};
/// The rotors carry this share of the weight once all legs have found the ground, and the greater one when the first
/// leg has found it, because on a slope the others are still in the air.
constexpr double settling_share = 0.2;
constexpr double touching_share = 0.8;
constexpr Seconds touching_time{0.6};
constexpr double spooling_share = 0.3;
constexpr Seconds ground_lost{0.3};
constexpr double calm_air_m_s = 0.1;

double settlingShare(Seconds since_touch) {
    const double touching = std::max(0.0, 1.0 - since_touch / touching_time);
    const double settling = std::max(0.0, 1.0 - since_touch / settling_time);
    return settling_share * settling + (touching_share - settling_share) * touching;
}

} // namespace

RotorDrive::RotorDrive(Physics& physics, BodyId body, bool near_ground, const AirRobotParameters& parameters)
    : physics_(physics)
    , parameters_(parameters)
    , id_(body)
    , rotors_(parameters_)
    , controller_(parameters_)
    , landing_itself_(near_ground) {
    controller_.reset(state());
    rotors_.start(parameters_.mass_kg * gravity_m_s2);
}

bool RotorDrive::obey(const protocol::Command& command) {
    const auto* const drive = std::get_if<protocol::AerialDrive>(&command);
    if (!drive)
        return false;
    landing_itself_ = false;
    takeTerm(drive->forward_m_s, parameters_.forward_limit_m_s, drive->normalized, command_.forward_m_s);
    takeTerm(drive->left_m_s, parameters_.sideways_limit_m_s, drive->normalized, command_.left_m_s);
    takeTerm(drive->climb_m_s, parameters_.climb_limit_m_s, drive->normalized, command_.climb_m_s);
    takeTerm(drive->yaw_rate_rad_s, parameters_.yaw_rate_limit_rad_s, drive->normalized, command_.yaw_rate_rad_s);
    return true;
}

void RotorDrive::weakenRotor(int rotor, double share) {
    rotors_.weaken(static_cast<std::size_t>(std::clamp(rotor, 1, 4) - 1), share);
}

void RotorDrive::addSettings(std::vector<protocol::Setting>& settings) const {
    settings.insert(settings.end(), {{"MaxLateralVelocity", "", parameters_.sideways_limit_m_s},
                                     {"MaxLinearVelocity", "", parameters_.forward_limit_m_s},
                                     {"MaxAltitudeVelocity", "", parameters_.climb_limit_m_s},
                                     {"MaxRotationalVelocity", "", parameters_.yaw_rate_limit_rad_s}});
}

void RotorDrive::beforeStep(Seconds dt) {
    const BodyState now = state();
    if (motors_ == MotorState::Idle || ended())
        rotors_.stop();
    else
        rotors_.command(wantedWrench(now, dt));
    rotors_.step(dt);
    const RotorWrench wrench = rotors_.wrench();
    const Vec3 through_air_m_s = now.velocity_m_s - wind_m_s_;
    const Vec3 drag_n = -parameters_.drag_kg_m * through_air_m_s.norm() * through_air_m_s;
    const Vec3 spin_drag_n_m = -parameters_.spin_drag_n_m_s * now.rate_rad_s;
    physics_.apply(id_, now.rotation * Vec3(0.0, 0.0, wrench.thrust_n) + drag_n,
                   now.rotation * wrench.torque_n_m + spin_drag_n_m);
}

RotorWrench RotorDrive::wantedWrench(const BodyState& now, Seconds dt) {
    if (motors_ == MotorState::Settling)
        return controller_.settle(now, settlingShare(in_state_));
    VelocityCommand wanted = command_;
    if (landing_itself_)
        wanted.climb_m_s = landing_itself_m_s;
    RotorWrench wrench = controller_.control(now, wanted, dt);
    if (motors_ == MotorState::SpoolingUp)
        wrench.thrust_n *= spooling_share + (1.0 - spooling_share) * std::min(1.0, in_state_ / spooling_time);
    return wrench;
}

void RotorDrive::afterStep(Seconds dt) {
    in_state_ += dt;
    since_gear_ += dt;
    collisions_.pass(dt);
    if (off_ && !ended())
        enter(MotorState::Dead);
    feelContacts();
    touchDown();
    leaveGround();
}

void RotorDrive::feelContacts() {
    double impulse_n_s = 0.0;
    bool broke = false;
    bool collided = false;
    for (const Contact& contact : physics_.contacts(id_)) {
        if (isTouchdown(contact)) {
            since_gear_ = Seconds{0.0};
            broke |= contact.closing_speed_m_s >= parameters_.safe_touchdown_m_s;
            continue;
        }
        collided = true;
        impulse_n_s += contact.impulse_n_s;
        broke = broke || (!broken() && reachesRotor(contact));
    }
    broke |= impulse_n_s > parameters_.breaking_impulse_n_s;
    if ((collided || broke) && !broken())
        collisions_.touch();
    if (broke && !broken())
        enter(MotorState::Broken);
}

/// To the engine the ring is a solid disc, so what lies on the ring, such as a roof, may press on it anywhere.
bool RotorDrive::reachesRotor(const Contact& contact) const {
    if (partAt(parameters_, contact.point_in_body_m) != AirRobotPart::RotorDisc)
        return false;
    if (contact.surface == Surface::Plant)
        return true; // Twigs reach through the ring.
    const BodyState now = state();
    return std::ranges::none_of(
        ringAsFarAsRotors(parameters_, contact.point_in_body_m.z() > 0.0), [&](const BodyBox& box) {
            return physics_.meetsBox(now.position_m + now.rotation * box.center_m,
                                     now.rotation * Eigen::AngleAxisd(box.yaw_rad, Vec3::UnitZ()), box.size_m, id_);
        });
}

bool RotorDrive::isTouchdown(const Contact& contact) const {
    const bool on_floor = contact.surface == Surface::Ground || contact.surface == Surface::Building;
    return on_floor && partAt(parameters_, contact.point_in_body_m) == AirRobotPart::Gear;
}

void RotorDrive::touchDown() {
    const bool on_gear = since_gear_ == Seconds{0.0};
    const bool sinking = landing_itself_ || command_.climb_m_s < sink_wish_m_s;
    if (motors_ == MotorState::Flying && on_gear && sinking)
        enter(MotorState::Settling);
    if (motors_ != MotorState::Settling)
        return;
    if (since_gear_ > ground_lost)
        enter(MotorState::Flying);
    else if (in_state_ > settling_time)
        enter(MotorState::Idle);
}

void RotorDrive::leaveGround() {
    const bool standing = motors_ == MotorState::Idle || motors_ == MotorState::Settling;
    if (standing && command_.climb_m_s > climb_wish_m_s)
        enter(MotorState::SpoolingUp);
    else if (motors_ == MotorState::SpoolingUp && in_state_ > spooling_time)
        motors_ = MotorState::Flying; // The controller keeps what it has learned on the way up.
}

void RotorDrive::feelWind(const Vec3& wind_in_map_m_s) {
    wind_m_s_ = wind_in_map_m_s;
    if (const bool calm = wind_m_s_.norm() < calm_air_m_s; calm != calm_) {
        calm_ = calm;
        mayRest();
    }
}

void RotorDrive::mayRest() {
    physics_.letSleep(id_, (motors_ == MotorState::Idle || ended()) && calm_);
}

void RotorDrive::enter(MotorState motors) {
    motors_ = motors;
    in_state_ = Seconds{0.0};
    mayRest();
    landing_itself_ = landing_itself_ && motors != MotorState::Idle;
    controller_.reset(state());
}

} // namespace usar::sim
