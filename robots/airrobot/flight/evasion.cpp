#include "robots/airrobot/flight/evasion.h"

#include <cmath>

namespace usar::airrobot {

namespace {

constexpr double berth_half_width_m = 0.8;
constexpr double escape_way_m = 1.6;
constexpr double bearing_step_rad = radians(15.0);

double sumOfRanges(const ThreatPicture& picture, std::size_t first, std::size_t end) {
    double sum = 0.0;
    for (std::size_t i = first; i < end; ++i)
        sum += picture.zones[i].range_m;
    return sum;
}

Vec2 pointAt(const Vec2& from_m, double bearing_rad, double distance_m) {
    return from_m + distance_m * Vec2(std::cos(bearing_rad), std::sin(bearing_rad));
}

} // namespace

std::optional<double> freeBearing(const ThreatPicture& picture) {
    if (!picture.greatest)
        return std::nullopt;
    const std::size_t threat = *picture.greatest;
    std::optional<std::size_t> left;
    std::optional<std::size_t> right;
    for (std::size_t i = threat; i-- > 0 && !left;)
        if (picture.zones[i].risk == agent::Risk::None)
            left = i;
    for (std::size_t i = threat + 1; i < picture.zones.size() && !right; ++i)
        if (picture.zones[i].risk == agent::Risk::None)
            right = i;
    if (!left && !right)
        return std::nullopt;
    const double left_sum = sumOfRanges(picture, 0, threat);
    const double right_sum = sumOfRanges(picture, threat + 1, picture.zones.size());
    const bool go_left = left && (!right || left_sum >= right_sum);
    return picture.zones[go_left ? *left : *right].bearing_rad;
}

bool mayIgnore(const ThreatPicture& picture, double free_bearing_rad, double goal_bearing_rad, double goal_distance_m) {
    const agent::SonarZone& threat = picture.zones[*picture.greatest];
    if (goal_distance_m < threat.range_m)
        return true;
    const double side = free_bearing_rad >= threat.bearing_rad ? 1.0 : -1.0;
    return side * goal_bearing_rad > side * free_bearing_rad;
}

std::optional<double> escapeBearing(std::span<const Obstacle> obstacles, const Vec2& from_m, double threat_bearing_rad,
                                    double needed_m) {
    const double back_rad = normalizedAngle(threat_bearing_rad + pi);
    for (int step = 0; step <= 7; ++step) {
        for (const int side : {1, -1}) {
            const double bearing_rad = normalizedAngle(back_rad + side * step * bearing_step_rad);
            if (clearance_m(obstacles, from_m, bearing_rad, berth_half_width_m, needed_m) >= needed_m)
                return bearing_rad;
        }
    }
    return std::nullopt;
}

void Evasion::observe(const Senses& senses, const ThreatPicture& picture, const Vec2& goal_m,
                      const Settings& settings) {
    last_risk_ = risk_;
    risk_ = picture.risk;
    matters_ = picture.risk == agent::Risk::High;
    if (picture.risk == agent::Risk::Low) {
        const Vec2 way_m = goal_m - senses.position2_m();
        const double goal_rad = normalizedAngle(bearingOf(goal_m - senses.position2_m()) - senses.base_in_map.yaw_rad);
        const auto free_rad = freeBearing(picture);
        matters_ = !free_rad || !mayIgnore(picture, *free_rad, goal_rad, way_m.norm());
    }
    if (matters_)
        calm_since_.reset();
    else
        calm(senses.now, settings);
}

std::optional<double> Evasion::escape_rad(const Senses& senses, const ThreatPicture& picture,
                                          std::span<const Obstacle> obstacles) {
    if (picture.risk != agent::Risk::High)
        return std::nullopt;
    const double threat_rad = senses.base_in_map.yaw_rad + picture.zones[*picture.greatest].bearing_rad;
    return escapeBearing(obstacles, senses.position2_m(), threat_rad, escape_way_m);
}

EvasionDecision Evasion::flee(const Senses& senses, const ThreatPicture& picture, std::span<const Obstacle> obstacles) {
    EvasionDecision decision;
    const auto escape = escape_rad(senses, picture, obstacles);
    decision.mode = escape ? EvasionMode::Flee : EvasionMode::Enclosed;
    decision.flee_bearing_rad = escape.value_or(0.0);
    decision.new_high_risk = last_risk_ != agent::Risk::High;
    mode_ = decision.mode;
    return decision;
}

EvasionDecision Evasion::divert(const Senses& senses, const ThreatPicture& picture, std::span<const Obstacle> obstacles,
                                const Settings& settings) {
    const Vec2 here_m = senses.position2_m();
    const double yaw_rad = senses.base_in_map.yaw_rad;
    const auto free_rad = freeBearing(picture);
    EvasionDecision decision;
    decision.new_low_risk = last_risk_ == agent::Risk::None;
    const double wanted_m = settings.diversion_distance_m;
    const bool open = free_rad && clearance_m(obstacles, here_m, yaw_rad + *free_rad, settings.side_clearance_m,
                                              wanted_m) >= wanted_m;
    decision.mode = open ? EvasionMode::Divert : EvasionMode::Enclosed;
    if (open) {
        const Vec2 point_m = pointAt(here_m, yaw_rad + *free_rad, wanted_m);
        decision.new_diversion = mode_ != EvasionMode::Divert || (point_m - diversion_m_).norm() > 1.0;
        diversion_m_ = point_m;
        decision.diversion_m = point_m;
    }
    mode_ = decision.mode;
    return decision;
}

EvasionDecision Evasion::keep() const {
    EvasionDecision decision;
    decision.mode = mode_;
    decision.diversion_m = diversion_m_;
    return decision;
}

EvasionDecision Evasion::decide(const Senses& senses, const ThreatPicture& picture, std::span<const Obstacle> obstacles,
                                const Settings& settings) {
    if (picture.risk == agent::Risk::High)
        return flee(senses, picture, obstacles);
    return matters_ ? divert(senses, picture, obstacles, settings) : keep();
}

void Evasion::calm(Seconds now, const Settings& settings) {
    if (!calm_since_ || now < *calm_since_)
        calm_since_ = now;
    // Adds one tick, because this one counts too, and a quarter, because printed times are rounded.
    const Seconds calm_for = now - *calm_since_ + 1.25 * usual_tick;
    if (calm_for >= static_cast<double>(settings.calm_cycles) * usual_tick || mode_ == EvasionMode::Flee ||
        mode_ == EvasionMode::Enclosed)
        mode_ = EvasionMode::None;
}

} // namespace usar::airrobot
