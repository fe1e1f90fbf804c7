#include "robots/submarine/trail.h"

#include <algorithm>
#include <cmath>

namespace usar::submarine {

namespace {

constexpr double turn_per_m = 0.1255; ///< radians per meter with the rudder hard over, at any speed, for REMUS-100 size
constexpr double apart_m = 4.0;
constexpr std::size_t most_places = 500;

} // namespace

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
