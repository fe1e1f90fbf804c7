#include "robots/airrobot/flight/craft.h"

#include <algorithm>

namespace usar::airrobot {

namespace {

constexpr Seconds longest_move{18.0};
constexpr double crown_m = 4.5;      ///< Crowns reach so far from their trunks.
constexpr double worth_a_move = 0.3; ///< A climb that lacks this share of the scan altitude is tried at another place,
constexpr std::size_t most_others = 4; ///< so often.
constexpr int most_stops = 4;          ///< after which it climbs where it is
constexpr double faces_rad = 0.3;
constexpr double spare_m = 1.2; ///< beyond its column, nothing is nearer than this
/// The sonars heard a trunk only on the way to the column, because it had been too far away, and its crown was above
/// that (random survey 166034).
constexpr double under_crown_m = 3.5;
constexpr double same_trunk_m = 1.0; ///< A sonar tells its place no better than this.

/// Where to climb if a trunk that was not known, which carries a crown, stands on the way to the place.
Vec2 clearOfTrunk_m(std::vector<Obstacle> trunks, const Senses& senses) {
    for (const SonarEcho& echo : senses.sonars)
        if (isNoGround(echo, senses))
            trunks.push_back({echo.center_in_map_m.head<2>(), echo.center_in_map_m.z(), true});
    return climbPlace_m(trunks, senses.position2_m(), crown_m);
}

/// True if a sonar hears something that was not `known` near the place of a climb, whose crown may be above it.
bool hearsNewTrunk(const Senses& senses, std::span<const Obstacle> known, const Vec2& place_m) {
    return std::ranges::any_of(senses.sonars, [&](const SonarEcho& echo) {
        const Vec2 at_m = echo.center_in_map_m.head<2>();
        return isNoGround(echo, senses) && (at_m - place_m).norm() < under_crown_m &&
               nearest_m(known, at_m, same_trunk_m) >= same_trunk_m;
    });
}

} // namespace

/// Returns the things around that are known to reach this height.
std::vector<Obstacle> Craft::trunksNear(const Vec2& at_m) const {
    std::vector<Obstacle> trunks = memory.near(at_m, look_around_m, senses.position_m().z() - trunk_margin_m);
    std::erase_if(trunks, [](const Obstacle& one) { return !one.top_known; }); // Sonars may have heard the ground.
    trunks.insert(trunks.end(), ascent_.heard().begin(), ascent_.heard().end());
    return trunks;
}

/// Keeps a climb clear of crowns.
void Craft::mindColumn(const AscentStep& step, Motion& motion) {
    const bool rolls = step.right_m_s != 0.0 || step.returns;
    if (rolls || overhead.hasCeiling() || senses.heightOverGround_m(1e9) < surely_aloft_m)
        return;
    const auto minding = column_.mind(senses, trunksNear(senses.position2_m()),
                                      log.lean().slope(senses.base_in_map.yaw_rad), commanded_climb_m_s_);
    motion.climb_m_s = std::min(motion.climb_m_s, minding.at_most_m_s);
    if (motion.climb_m_s > 0.0 && minding.turns)
        motion.yaw_rate_rad_s = settings.turn_rate_rad_s;
}

/// Chooses another place for the climb if a ceiling ends it early here: it may be a floor on posts, or a crown.
bool Craft::riseElsewhere(double goal_z_m) {
    const Vec2 here_m = senses.position2_m();
    if (overhead.limit_m(here_m) > goal_z_m - worth_a_move * settings.scan_altitude_m ||
        column_.others_m.size() >= most_others)
        return false;
    overhead.takeForSmall(true, senses.position_m().z());
    const auto near = memory.near(here_m, look_around_m, senses.position_m().z() - trunk_margin_m);
    column_.moveTo(otherColumn_m(near, here_m, overhead, column_.others_m), senses.now);
    column_.others_m.push_back(*column_.at_m);
    return true;
}

bool Craft::rise(double goal_z_m, const Vec2& over_m, agent::CommandPort& port) {
    ascending_ = true;
    const Vec2 column_m = column_.at_m.value_or(over_m);
    const AscentStep step = ascent_.step(senses, {column_m.x(), column_m.y(), goal_z_m}, overhead, memory, settings);
    if (step.looked_around)
        column_.moveTo(climbPlace_m(trunksNear(over_m), over_m, crown_m), senses.now);
    if (overhead.found() && overhead.found()->touched) // One that it sees from beside may be a crown among others.
        riseElsewhere(goal_z_m);
    if (column_.at_m && senses.now - column_.moving_since > longest_move / senses.steadyShare() && !column_.there)
        column_.at_m = senses.position2_m(); // Something is in the way.
    const double standoff_m = column_.others_m.empty() ? settings.climb_standoff_m : room_to_climb_m;
    const double ahead_m = std::min(standoff_m, (column_m - senses.position2_m()).norm() + spare_m);
    if (column_.at_m && !column_.there && column_.faced) {
        const auto known = trunksNear(senses.position2_m());
        const bool may_choose = column_.stops < most_stops;
        if (hearsAhead(senses, ahead_m) || (may_choose && hearsNewTrunk(senses, known, column_m)))
            column_.moveTo(++column_.stops < most_stops ? clearOfTrunk_m(known, senses) : senses.position2_m(),
                           senses.now);
        ascent_.listen(senses);
    }
    Motion motion = holding(senses, column_m);
    const Vec2 way_m = column_m - senses.position2_m();
    column_.there = way_m.norm() < in_column_m;
    column_.faced = std::abs(normalizedAngle(bearingOf(way_m) - senses.base_in_map.yaw_rad)) < faces_rad;
    if (column_.at_m && !column_.there) // It looks where it goes, because no sonar looks backward.
        motion = toward(senses, bearingOf(way_m), motion.velocity_in_map_m_s.norm(), settings);
    makeSafe(motion);
    motion.climb_m_s = column_.there ? step.climb_m_s : std::min(step.climb_m_s, 0.0);
    mindColumn(step, motion);
    if (step.turns)
        motion.yaw_rate_rad_s = settings.turn_rate_rad_s;
    motion.sudden = step.returns;
    if (step.right_m_s != 0.0) {
        const double yaw_rad = senses.base_in_map.yaw_rad;
        const double right_m_s = std::clamp(step.right_m_s, -fastest_m_s_, fastest_m_s_);
        motion.velocity_in_map_m_s = right_m_s * Vec2(std::sin(yaw_rad), -std::cos(yaw_rad));
        motion.sudden = true;
    }
    command(step.right_m_s != 0.0 ? motion : calmed(motion, senses, settings), port,
            step.right_m_s != 0.0 ? "looking up" : "taking off");
    const bool is_up = step.reached && (column_.others_m.empty() || (column_.there && !riseElsewhere(goal_z_m)));
    if (is_up)
        expectCanopy();
    return is_up || column_.givesUp();
}

} // namespace usar::airrobot
