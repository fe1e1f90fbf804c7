#include "robots/airrobot/flight/threat_zones.h"

#include <algorithm>
#include <cmath>

namespace usar::airrobot {

namespace {

constexpr double ring_step_rad = radians(18.0);
constexpr std::size_t last_ring = 4;
/// The body extends 0.1 m up and down; the rest is for tilt and drift.
constexpr double level_tolerance_m = 0.5;
constexpr double on_way_rad = radians(50.0); ///< An echo that is farther aside does not count as on the way.

bool atOurLevel(const SonarEcho& echo, double base_z_m) {
    return echo.high_m > base_z_m - level_tolerance_m && echo.low_m < base_z_m + level_tolerance_m;
}

} // namespace

std::size_t ringOf(double bearing_rad) {
    const double steps = std::abs(normalizedAngle(bearing_rad)) / ring_step_rad;
    return std::min(last_ring, static_cast<std::size_t>(std::lround(steps)));
}

ThreatPicture judgeThreats(const Senses& senses, const Settings& settings) {
    ThreatPicture picture;
    for (const SonarEcho& echo : senses.sonars) {
        const std::size_t ring = ringOf(echo.bearing_rad);
        agent::SonarZone zone{echo.name,        echo.bearing_rad,         echo.range_m,
                              echo.maximum_m,   settings.lowRisk_m(ring), settings.highRisk_m(ring),
                              agent::Risk::None};
        if (echo.hit && atOurLevel(echo, senses.base_in_map.position_m.z())) {
            if (zone.range_m < zone.high_risk_below_m)
                zone.risk = agent::Risk::High;
            else if (zone.range_m < zone.low_risk_below_m)
                zone.risk = agent::Risk::Low;
        }
        picture.zones.push_back(std::move(zone));
    }
    for (std::size_t i = 0; i < picture.zones.size(); ++i) {
        const agent::SonarZone& zone = picture.zones[i];
        if (zone.risk == agent::Risk::None || zone.risk < picture.risk)
            continue;
        if (zone.risk > picture.risk || zone.range_m < picture.zones[*picture.greatest].range_m)
            picture.greatest = i;
        picture.risk = zone.risk;
    }
    return picture;
}

bool isWayClear(const ThreatPicture& picture, double way_rad) {
    return std::ranges::none_of(picture.zones, [&](const agent::SonarZone& zone) {
        return zone.risk == agent::Risk::High && std::abs(normalizedAngle(zone.bearing_rad - way_rad)) <= on_way_rad;
    });
}

ThreatPicture noThreats(ThreatPicture picture) {
    for (agent::SonarZone& zone : picture.zones)
        zone.risk = agent::Risk::None;
    picture.risk = agent::Risk::None;
    picture.greatest.reset();
    return picture;
}

} // namespace usar::airrobot
