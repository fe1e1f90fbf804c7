#include "robots/airrobot/flight/belly_touch.h"

#include <algorithm>
#include <cmath>

#include "robots/airrobot/flight/overhead.h"
#include "robots/airrobot/flight/ring_touch.h"

namespace usar::airrobot {

namespace {

/// The time constant with which the rate of climb follows its command, see Overhead.
constexpr Seconds follows_within{0.6};
/// It has sunk by less than this share of what it was told for so long.
constexpr Seconds held{0.6};
constexpr double sunk_share = 0.3;
constexpr double least_sink_m_s = 0.15;
constexpr double least_sink_m = 0.15; ///< that it was told to sink in this time
constexpr double least_lean = 0.06;
constexpr double tipping_lean = 0.2;
/// In 3,300 ticks in which healthy robots sank, two leaned by more than this all at once. One that sank as it backed
/// away from a rack tipped over an edge (`tst_random_surveys_campaign`, number 160949).
constexpr double sudden_lean = 0.25;
constexpr double least_tipping_m_s = 0.05; ///< It slides down on one side.
constexpr double standing_m_s = 0.3;       ///< A faster robot may lean because it brakes.
constexpr double aloft_m = 0.7;            ///< A robot that lands and is lower may stand on the ground.
constexpr double belly_reach_m = 0.3;      ///< from the robot's center to what it rests on
constexpr double belly_depth_m = 0.1;      ///< and from there down to the belly
constexpr double rises_by_m = 0.8;
constexpr Seconds longest_rise{4.0};
constexpr double level_lean = 0.09; ///< A robot that leans less is level.
constexpr double held_lean = 0.15;  ///< A robot that was level and leans so far as it rises on is held on one side.
constexpr Seconds sinking{1.0};
const Motion sinks_from_beside{.climb_m_s = -Overhead::gentle_m_s};

} // namespace

void BellyTouch::follow(const Senses& senses, const Doing& doing) {
    const double z_m = senses.position_m().z();
    if (samples_.empty()) {
        free_m_s_ = senses.velocity_in_map_m_s.z();
        samples_.push_back({senses.now, z_m, z_m});
        return;
    }
    const Sample last = samples_.back();
    const Seconds since_last = senses.now - last.time;
    free_m_s_ += std::min(1.0, since_last / follows_within) * (doing.climb_m_s - free_m_s_);
    samples_.push_back({senses.now, z_m, last.free_m + free_m_s_ * since_last.count()});
    while (senses.now - samples_[1].time >= held + senses.late)
        samples_.erase(samples_.begin());
}

bool BellyTouch::rests(const Senses& senses) const {
    const Sample& first = samples_.front();
    const double told_m = first.free_m - samples_.back().free_m;
    const double sunk_m = first.z_m - samples_.back().z_m;
    return senses.now - first.time >= held + senses.late && told_m > least_sink_m && sunk_m < sunk_share * told_m;
}

/// True if it leans as nothing makes it lean in calm air, or in a moment, but an edge over which it tips.
bool BellyTouch::tips(const Senses& senses, const Vec2& lean, const Doing& doing) {
    if (doing.leans_more > sudden_lean)
        return true;
    const bool sinks = senses.velocity_in_map_m_s.z() < -least_tipping_m_s;
    return sinks && !doing.in_wind && senses.late <= Seconds{0.0} && lean.norm() > tipping_lean &&
           doing.speed_m_s < standing_m_s && senses.velocity_in_map_m_s.head<2>().norm() < standing_m_s;
}

std::optional<Motion> BellyTouch::free(const Senses& senses, const Vec2& slope, const Doing& doing) {
    met_m_.reset();
    const bool sinks_free = sinks_since_ && senses.now - *sinks_since_ < sinking;
    const bool may_stand = doing.to_ground && senses.heightOverGround_m(1e9) < aloft_m;
    if (sinks_free || doing.from_above || senses.ins_age > Seconds{0.0} || may_stand) {
        samples_.clear();
        return sinks_free ? std::optional(sinks_from_beside) : std::nullopt;
    }
    follow(senses, doing);
    const double z_m = senses.position_m().z();
    const Vec2 lean = unusualLean(senses, slope);
    const bool sinks = doing.climb_m_s < -least_sink_m_s * senses.steadyShare();
    if (sinks && lean.norm() > least_lean && (rests(senses) || tips(senses, lean, doing))) {
        const Vec2 at_m = senses.position2_m() - belly_reach_m * lean.normalized();
        met_m_ = Vec3(at_m.x(), at_m.y(), z_m - belly_depth_m);
        rises_to_m_ = z_m + rises_by_m;
        rising_since_ = senses.now;
        level_ = false;
    }
    if (rises_to_m_ && (z_m > *rises_to_m_ || senses.now - rising_since_ > longest_rise))
        rises_to_m_.reset();
    level_ = level_ || lean.norm() < level_lean;
    if (rises_to_m_ && level_ && !doing.in_wind && lean.norm() > held_lean) {
        rises_to_m_.reset();
        sinks_since_ = senses.now;
        return sinks_from_beside;
    }
    return rises_to_m_ ? std::optional(Motion{.climb_m_s = Overhead::careful_m_s}) : std::nullopt;
}

} // namespace usar::airrobot
