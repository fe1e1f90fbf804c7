#include "robots/airrobot/flight/craft.h"

#include <algorithm>

namespace usar::airrobot {

namespace {

/// So near to a roof, the robot does nothing but sink: a turn or a lean makes a rotor scrape along it, which breaks it.
constexpr double near_roof_m = 0.35;
/// A robot without a pose sinks away from a roof for so long and no longer, because it does not see how far it sinks.
constexpr Seconds longest_press{6.0};
/// It backs away from what holds it at least so fast, whatever is near on that side, and at least so fast through the
/// air: while it leans against a wind that blows it away from that, it presses against that.
constexpr double least_away_m_s = 0.25;
constexpr double least_away_through_air_m_s = 0.3;

/// A robot that sank by 0.4 m away from what held its ring beside racks caught on one and turned over (random surveys
/// 168461 and 168653). What is higher than its belly is beside it.
constexpr double belly_m = 0.1;
constexpr double just_below_m = 1.2;

} // namespace

void Craft::command(const Motion& motion, agent::CommandPort& port, const std::string& source) {
    const bool below_roof = touchesRoof();
    Motion safe = below_roof ? Motion{.climb_m_s = -Overhead::gentle_m_s} : motion;
    if (const auto under_lid = ways.sink(senses)) {
        safe = *under_lid;
        makeSafe(safe);
    }
    const Vec2 told_m_s = Eigen::Rotation2Dd(senses.base_in_map.yaw_rad) * pilot_.wantedInBase_m_s();
    const double z_m = senses.position_m().z();
    const double below_m =
        memory.highest_m(senses.position2_m(), settings.footprint_radius_m, z_m - belly_m).value_or(-1e9);
    const auto away = touches_.side.free(senses, {pilot_.told().yaw_rate_rad_s, told_m_s, commanded_climb_m_s_,
                                                  motion.to_ground, z_m - below_m < just_below_m});
    if (const auto& met_m = touches_.side.met_m())
        memory.touch(*met_m);
    // A thing that holds it looks like wind from ahead, and there is no wind below a ceiling: it pressed ever harder
    // against a wall, and broke (random survey 168861).
    if (touches_.side.holdsFast() || (touches_.side.met_m() && overhead.hasCeiling()))
        pilot_.forgetDrift();
    if (away && !below_roof) {
        safe = *away;
        makeSafe(safe);
        const Vec2 direction = away->velocity_in_map_m_s.normalized();
        const double least_m_s =
            std::max(least_away_m_s, pilot_.drift_m_s().dot(direction) + least_away_through_air_m_s);
        if (safe.velocity_in_map_m_s.norm() < least_m_s)
            safe.velocity_in_map_m_s = least_m_s * direction;
        // What the robot has met in a climb also presses on it from above. One robot went aside without sinking, and
        // stayed in a crown until it broke (random survey 171904). The robot has come from below, so it can sink there.
        if (climb_over_.mayBePressed(z_m))
            safe.climb_m_s = std::min(safe.climb_m_s, motion.climb_m_s);
    }
    // The robot leans on what its belly rests on, too. It would not get away from that if it sank.
    const double climb_m_s = touches_.belly.rises() ? 0.0 : commanded_climb_m_s_;
    const auto sinking = touches_.top.free(senses, {told_m_s, climb_m_s});
    if (touches_.top.met_m())
        memory.touch(*touches_.top.met_m());
    if (sinking && away)
        safe.climb_m_s = std::min(safe.climb_m_s, sinking->climb_m_s);
    else if (sinking && safe.climb_m_s > sinking->climb_m_s)
        safe = *sinking;
    const BellyTouch::Doing doing{.climb_m_s = commanded_climb_m_s_,
                                  .speed_m_s = pilot_.wantedInBase_m_s().norm(),
                                  .in_wind = pilot_.feelsWind(),
                                  .from_above =
                                      below_roof || climb_over_.mayBePressed(senses.position_m().z()) || sinking,
                                  .to_ground = motion.to_ground,
                                  .leans_more = touches_.top.leansMore()};
    if (const auto freeing = touches_.belly.free(senses, log.lean().slope(senses.base_in_map.yaw_rad), doing))
        safe = *freeing;
    if (touches_.belly.met_m())
        stayAbove(*touches_.belly.met_m());
    commanded_climb_m_s_ = safe.climb_m_s;
    pilot_.fly(safe, senses, port, source, settings);
}

/// Keeps the robot from sinking onto that again. It may be a wire and reach far.
void Craft::stayAbove(const Vec3& met_m) {
    memory.touch(met_m);
    ways.touch(senses, met_m.head<2>());
    const Vec3 here_m = senses.position_m();
    climbed_at_ = Vec3(here_m.x(), here_m.y(), met_m.z() + settings.clearance_m);
}

bool Craft::touchesRoof() const {
    const auto ceiling_m = overhead.ceiling_m(senses.position2_m());
    const bool over_lid = ways.sink(senses).has_value(); // That is no roof.
    return ceiling_m && !over_lid && senses.position_m().z() > *ceiling_m - near_roof_m;
}

void Craft::brace(agent::CommandPort& port, const std::string& source) {
    stuck_.wait(senses.now);
    // A robot that has pressed against a roof keeps its place for a moment, as if its pose were hanging.
    const bool pressed = touchesRoof() && senses.ins_age < longest_press;
    commanded_climb_m_s_ = pressed ? -Overhead::gentle_m_s : 0.0;
    pilot_.brace(senses, commanded_climb_m_s_, port, source);
}

} // namespace usar::airrobot
