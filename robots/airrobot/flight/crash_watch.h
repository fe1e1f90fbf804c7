// Notices that the robot has crashed, by what its own sensors say.
#pragma once

#include <cmath>
#include <optional>

#include "robots/airrobot/flight/senses.h"

namespace usar::airrobot {

/// Call `update` once per tick in the air. Owned by one robot; make a new one for each flight.
class CrashWatch {
public:
    /// The command of the last tick.
    struct Asked {
        double speed_m_s = 0.0; ///< level
        double climb_m_s = 0.0; ///< positive upward
    };

    /// Returns what happened, as the end of a sentence about the robot; nullptr if it flies.
    const char* update(const Senses& senses, const Asked& asked) {
        const Pose& pose = senses.base_in_map;
        const bool over = std::cos(pose.roll_rad) * std::cos(pose.pitch_rad) < std::cos(turned_over_rad);
        const bool falls = senses.velocity_in_map_m_s.z() < -falling_m_s;
        const double height_m = senses.heightOverGround_m(1e9);
        has_flown_ = has_flown_ || height_m > 2.0 * lying_m;
        const bool lies = has_flown_ && senses.velocity_in_map_m_s.norm() < resting_m_s && height_m < lying_m &&
                          (asked.speed_m_s > asked_m_s || asked.climb_m_s > asked_m_s);
        if (lasts(over, over_since_, senses.now, short_time))
            return "it has turned over";
        // A damaged line may let the pose leap down; while no other comes, its rate tells nothing new.
        if (senses.ins_age <= Seconds{0.0} && lasts(falls, falls_since_, senses.now, short_time))
            return "it falls";
        if (lasts(lies, lies_since_, senses.now, long_time))
            return "it lies on the ground and does not answer";
        return nullptr;
    }

private:
    static constexpr double turned_over_rad = radians(60.0);
    static constexpr double falling_m_s = 3.0; ///< more than twice the greatest commanded rate
    static constexpr double resting_m_s = 0.04;
    static constexpr double lying_m = 0.5; ///< height of the base over the ground
    static constexpr double asked_m_s = 0.15;
    static constexpr Seconds short_time{0.5};
    static constexpr Seconds long_time{6.0};

    static bool lasts(bool is_so, std::optional<Seconds>& since, Seconds now, Seconds long_enough) {
        if (!is_so)
            since.reset();
        else if (!since)
            since = now;
        return since && now - *since >= long_enough;
    }

    bool has_flown_ = false; ///< A robot that never left the ground has not crashed.
    std::optional<Seconds> over_since_;
    std::optional<Seconds> falls_since_;
    std::optional<Seconds> lies_since_;
};

} // namespace usar::airrobot
