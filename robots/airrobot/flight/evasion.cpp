#include "robots/airrobot/flight/evasion.h"

#include <algorithm>
#include <cmath>

namespace usar::airrobot {

namespace {

constexpr double berth_half_width_m = 0.8;
constexpr double escape_way_m = 1.6;
constexpr double bearing_step_rad = radians(15.0);
/// By then it flees as fast as it is told, in calm air. Below a ceiling the air is always calm.
constexpr Seconds sudden_time{2.0};

bool isFree(const agent::SonarZone& zone) {
    return zone.risk == agent::Risk::None;
}

double sumOfRanges(std::span<const agent::SonarZone> zones) {
    double sum = 0.0;
    for (const agent::SonarZone& zone : zones)
        sum += zone.range_m;
    return sum;
}

} // namespace

std::optional<double> freeBearing(const ThreatPicture& picture) {
    if (!picture.greatest)
        return std::nullopt;
    const std::span zones(picture.zones);
    const auto to_the_left = zones.first(*picture.greatest);
    const auto to_the_right = zones.subspan(*picture.greatest + 1);
    const auto left = std::find_if(to_the_left.rbegin(), to_the_left.rend(), isFree);
    const auto right = std::ranges::find_if(to_the_right, isFree);
    const bool left_free = left != to_the_left.rend();
    const bool right_free = right != to_the_right.end();
    if (!left_free && !right_free)
        return std::nullopt;
    const bool go_left = left_free && (!right_free || sumOfRanges(to_the_left) >= sumOfRanges(to_the_right));
    return go_left ? left->bearing_rad : right->bearing_rad;
}

bool mayIgnore(const ThreatPicture& picture, double free_bearing_rad, double goal_bearing_rad, double goal_distance_m) {
    const agent::SonarZone& threat = picture.zones[*picture.greatest];
    if (goal_distance_m < threat.range_m)
        return true;
    const double side = free_bearing_rad >= threat.bearing_rad ? 1.0 : -1.0;
    return side * goal_bearing_rad > side * free_bearing_rad;
}

std::optional<double> escapeBearing(std::span<const Obstacle> obstacles, const Vec2& from_m, double threat_bearing_rad,
                                    double needed_m, const Retreat& retreat) {
    const double back_rad = normalizedAngle(threat_bearing_rad + pi);
    for (int step = 0; step <= 7; ++step) {
        for (const int side : {1, -1}) {
            const double bearing_rad = normalizedAngle(back_rad + side * step * bearing_step_rad);
            if (clearance_m(obstacles, from_m, bearing_rad, berth_half_width_m, needed_m) < needed_m)
                continue;
            const Vec2 along(std::cos(bearing_rad), std::sin(bearing_rad));
            if (!retreat.only_there || retreat.flown(from_m + needed_m * along))
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
        const double goal_rad = normalizedAngle(bearingOf(way_m) - senses.base_in_map.yaw_rad);
        const auto free_rad = freeBearing(picture);
        matters_ = !free_rad || !mayIgnore(picture, *free_rad, goal_rad, way_m.norm());
    }
    if (matters_)
        calm_since_.reset();
    else
        calm(senses.now, settings);
}

std::optional<double> Evasion::escape_rad(const Senses& senses, const ThreatPicture& picture,
                                          std::span<const Obstacle> obstacles, const Retreat& retreat) {
    if (picture.risk != agent::Risk::High)
        return std::nullopt;
    const double threat_rad = senses.base_in_map.yaw_rad + picture.zones[*picture.greatest].bearing_rad;
    return escapeBearing(obstacles, senses.position2_m(), threat_rad, escape_way_m, retreat);
}

EvasionDecision Evasion::flee(const Senses& senses, const ThreatPicture& picture, std::span<const Obstacle> obstacles,
                              const Retreat& retreat) {
    const auto escape = escape_rad(senses, picture, obstacles, retreat);
    if (mode_ != EvasionMode::Flee)
        fled_since_ = senses.now;
    mode_ = escape ? EvasionMode::Flee : EvasionMode::Enclosed;
    return {.mode = mode_,
            .flee_bearing_rad = escape.value_or(0.0),
            .sudden = retreat.only_there || senses.now - fled_since_ < sudden_time + senses.late,
            .new_high_risk = last_risk_ != agent::Risk::High};
}

EvasionDecision Evasion::divert(const Senses& senses, const ThreatPicture& picture, std::span<const Obstacle> obstacles,
                                const Settings& settings) {
    const Vec2 here_m = senses.position2_m();
    const auto free_rad = freeBearing(picture);
    const double bearing_rad = senses.base_in_map.yaw_rad + free_rad.value_or(0.0);
    const double wanted_m = settings.diversion_distance_m;
    const bool open =
        free_rad && clearance_m(obstacles, here_m, bearing_rad, settings.side_clearance_m, wanted_m) >= wanted_m;
    EvasionDecision decision{.mode = open ? EvasionMode::Divert : EvasionMode::Enclosed,
                             .new_low_risk = last_risk_ == agent::Risk::None};
    if (open) {
        decision.diversion_m = here_m + wanted_m * Vec2(std::cos(bearing_rad), std::sin(bearing_rad));
        decision.new_diversion = mode_ != EvasionMode::Divert || (decision.diversion_m - diversion_m_).norm() > 1.0;
        diversion_m_ = decision.diversion_m;
    }
    mode_ = decision.mode;
    return decision;
}

EvasionDecision Evasion::decide(const Senses& senses, const ThreatPicture& picture, std::span<const Obstacle> obstacles,
                                const Settings& settings, const Retreat& retreat) {
    if (picture.risk == agent::Risk::High)
        return flee(senses, picture, obstacles, retreat);
    if (matters_)
        return divert(senses, picture, obstacles, settings);
    return {.mode = mode_, .diversion_m = diversion_m_};
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
