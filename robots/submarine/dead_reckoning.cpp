#include "robots/submarine/dead_reckoning.h"

#include <algorithm>
#include <cmath>

namespace usar::submarine {

namespace {

// Values of a torpedo-shaped vehicle of REMUS-100 size (robots-and-worlds.md 3.3); masses include the water that moves
// along.
constexpr double mass_kg = 38.0;
constexpr double heave_mass_kg = 72.5;
constexpr double inertia_kg_m2 = 8.3;
constexpr double thrust_n = 10.0; ///< at full propeller speed; proportional to the square of the speed
constexpr double surge_drag_kg_m = 3.9;
constexpr double heave_drag_kg_m = 131.0;
constexpr double pitch_drag_kg_m2 = 188.0;
constexpr double righting_n_m = 7.3; ///< weight times the height of the center of buoyancy over the center of mass
constexpr double fin_moment_kg = 6.15;
constexpr double fin_lift_kg_m = 9.64;

constexpr double longest_step_s = 0.02;
constexpr double least_flow_m2_s2 = 0.2; ///< lower limit for the squared speed, below which planes have no effect
constexpr double hurry_n_m = 20.0;       ///< wanted moment per radian of pitch error
constexpr double calm_n_m_s = 18.0;      ///< damping moment per rad/s

constexpr double turn_per_m = 0.1255; ///< radians per meter with the rudder hard over, at any speed, for REMUS-100 size
constexpr double apart_m = 4.0;
constexpr std::size_t most_places = 500;

} // namespace

void PitchModel::step(Seconds dt, double propeller_share, double stern_plane_rad) {
    const double push_n = thrust_n * propeller_share * std::abs(propeller_share);
    const int steps = std::max(1, static_cast<int>(std::ceil(dt.count() / longest_step_s)));
    for (int i = 0; i < steps; ++i)
        stepOnce(dt.count() / steps, push_n, stern_plane_rad);
}

void PitchModel::stepOnce(double dt_s, double thrust_now_n, double stern_plane_rad) {
    const double flow_m2_s2 = speed_m_s_ * std::abs(speed_m_s_);
    const double moment_n_m = fin_moment_kg * flow_m2_s2 * stern_plane_rad - righting_n_m * std::sin(pitch_rad_) -
                              pitch_drag_kg_m2 * rate_rad_s_ * std::abs(rate_rad_s_);
    const double heave_n =
        -fin_lift_kg_m * flow_m2_s2 * stern_plane_rad - heave_drag_kg_m * heave_m_s_ * std::abs(heave_m_s_);
    // While the nose turns up, the hull keeps its velocity, which then has a component across the hull, toward its
    // belly.
    heave_m_s_ += (heave_n / heave_mass_kg - speed_m_s_ * rate_rad_s_) * dt_s;
    speed_m_s_ += (thrust_now_n - surge_drag_kg_m * flow_m2_s2) / mass_kg * dt_s;
    rate_rad_s_ += moment_n_m / inertia_kg_m2 * dt_s;
    pitch_rad_ += rate_rad_s_ * dt_s;
}

double PitchModel::climb_m_s() const {
    return speed_m_s_ * std::sin(pitch_rad_) + heave_m_s_ * std::cos(pitch_rad_);
}

double PitchModel::planeFor_rad(double pitch_rad) const {
    const double flow_m2_s2 = std::copysign(std::max(least_flow_m2_s2, speed_m_s_ * speed_m_s_), speed_m_s_);
    const double moment_n_m =
        righting_n_m * std::sin(pitch_rad) + hurry_n_m * (pitch_rad - pitch_rad_) - calm_n_m_s * rate_rad_s_;
    return moment_n_m / (fin_moment_kg * flow_m2_s2);
}

void Trail::step(double step_m, double rudder_share) {
    // The turning moment is proportional to the rudder angle and the drag to the square of the turn rate.
    const double turn_share = std::copysign(std::sqrt(std::abs(rudder_share)), rudder_share);
    yaw_rad_ = normalizedAngle(yaw_rad_ - turn_per_m * step_m * turn_share);
    here_m_ += step_m * Vec2(std::cos(yaw_rad_), std::sin(yaw_rad_));
}

void Trail::keepPlace() {
    if (!places_m_.empty() && distanceTo_m(places_m_.back()) < apart_m)
        return;
    places_m_.push_back(here_m_);
    if (places_m_.size() > most_places)
        places_m_.pop_front();
}

std::optional<Vec2> Trail::placeBehind(double distance_m) const {
    if (places_m_.empty())
        return std::nullopt;
    const auto far = std::find_if(places_m_.rbegin(), places_m_.rend(),
                                  [&](const Vec2& place_m) { return distanceTo_m(place_m) > distance_m; });
    return far == places_m_.rend() ? places_m_.front() : *far;
}

double Trail::bearingOf_rad(const Vec2& place_m) const {
    const Vec2 way_m = place_m - here_m_;
    return normalizedAngle(std::atan2(way_m.y(), way_m.x()) - yaw_rad_);
}

} // namespace usar::submarine
