#include "robots/airrobot/flight/flight_log.h"

#include <algorithm>
#include <cmath>

namespace usar::airrobot {

namespace {
constexpr double path_step_m = 1.0;
constexpr double goal_step_m = 0.5;
constexpr double lowest_scan_m = 2.0;
constexpr Seconds mean_over{4.0};
constexpr double least_aside_m = 0.5; ///< less is no wind
constexpr double reach_m = 20.0;      ///< height to assume if nothing below is within the scanner's reach
} // namespace

void Lean::note(const Senses& senses) {
    const Pose& pose = senses.base_in_map;
    const double gain = noted_ ? 1.0 - std::exp(-(senses.now - *noted_) / mean_over) : 0.0;
    noted_ = senses.now;
    roll_rad_ += gain * (pose.roll_rad - roll_rad_);
    pitch_rad_ += gain * (pose.pitch_rad - pitch_rad_);
}

double Lean::tiltFrom_rad(const Pose& pose) const {
    return std::max(std::abs(pose.roll_rad - roll_rad_), std::abs(pose.pitch_rad - pitch_rad_));
}

Vec2 Lean::slope(double yaw_rad) const {
    const Vec3 up = Pose{Vec3::Zero(), roll_rad_, pitch_rad_, yaw_rad}.rotation() * Vec3::UnitZ();
    return -up.head<2>() / up.z();
}

Vec2 Lean::scanAside_m(double yaw_rad, double altitude_m) const {
    const Vec2 aside_m = altitude_m * slope(yaw_rad);
    return aside_m.norm() < least_aside_m ? Vec2(Vec2::Zero()) : aside_m;
}

bool goodForMap(const Senses& senses, bool airborne, const Lean& lean, const Settings& settings) {
    if (!airborne || !senses.scan || senses.heightOverGround_m(reach_m) < lowest_scan_m)
        return false;
    return lean.tiltFrom_rad(senses.scan->base_in_map) <= settings.maximum_scan_tilt_rad &&
           std::abs(senses.yaw_rate_rad_s) <= settings.maximum_scan_turn_rad_s;
}

void FlightLog::mark(agent::MarkKind kind, const Vec2& place_m, const Senses& senses, agent::CommandPort& port) const {
    const Vec3 position_m(place_m.x(), place_m.y(), senses.position_m().z());
    port.publish(agent::MapMark{kind, position_m, senses.now, senses.line});
}

bool FlightLog::tick(const Senses& senses, bool airborne, const Settings& settings, agent::CommandPort& port) {
    port.publish(agent::PoseEstimate{senses.now, senses.level_in_map});
    if (airborne)
        lean_.note(senses);
    const bool good = goodForMap(senses, airborne, lean_, settings);
    if (good)
        port.publish(agent::ScanPlacement{senses.scan->line, senses.scan->level_scanner_in_map});
    if (airborne && (!last_path_m_ || (senses.position_m() - *last_path_m_).norm() >= path_step_m)) {
        last_path_m_ = senses.position_m();
        mark(agent::MarkKind::Path, senses.position2_m(), senses, port);
    }
    return good;
}

void FlightLog::risks(const Senses& senses, const EvasionDecision& decision, agent::CommandPort& port) const {
    if (decision.new_high_risk)
        mark(agent::MarkKind::HighRisk, senses.position2_m(), senses, port);
    if (decision.new_low_risk)
        mark(agent::MarkKind::LowRisk, senses.position2_m(), senses, port);
    if (decision.new_diversion)
        mark(agent::MarkKind::Diversion, decision.diversion_m, senses, port);
}

void FlightLog::goal(std::optional<Vec3> goal_in_map_m, agent::CommandPort& port) {
    const bool same = goal_in_map_m.has_value() == last_goal_m_.has_value() &&
                      (!goal_in_map_m || (*goal_in_map_m - *last_goal_m_).norm() < goal_step_m);
    if (same)
        return;
    last_goal_m_ = goal_in_map_m;
    port.publish(agent::CurrentGoal{goal_in_map_m});
}

} // namespace usar::airrobot
