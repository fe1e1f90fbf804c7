// Estimate of the time that a survey still needs: lanes at the pace of those flown so far, charging trips, way home.
#pragma once

#include <optional>

#include "core/base/clock.h"
#include "robots/airrobot/survey.h"

namespace usar::airrobot {

/// Where the robot is in its mission, besides its lanes. Places are in the map frame.
struct MissionState {
    Vec2 position_m = Vec2::Zero();
    Vec2 base_m = Vec2::Zero();
    double since_charge_m = 0.0; ///< distance flown since the last charge
    Seconds waiting{0.0};        ///< time until it flies on: for the rest of a landing, charge or take-off
    bool lanes_left = true;      ///< the lanes that are not done will be flown
    bool returning = false;      ///< it is in the air on its way to the base, to land there
};

/// Learns how much longer lanes take than at scan speed, which is mostly because of evasion, and flies the rest of the
/// mission in thought. Owned by one robot.
class TimeEstimate {
public:
    /// Call it once per tick. `done_m`: Survey::doneLength_m. Only time on a lane teaches, and no pause.
    void note(bool on_lane, Seconds now, double done_m, const Settings& settings);
    /// Time until the robot has landed at its base for good, if nothing stops it.
    Seconds timeLeft(const Survey& survey, const MissionState& state, const Settings& settings) const;
    /// Estimates when the mission ends, at most once a second, because a long survey has many lanes.
    void update(Seconds now, const Survey& survey, const MissionState& state, const Settings& settings);
    /// Time until the end by the last estimate; nullopt before the first.
    std::optional<Seconds> left(Seconds now) const;
    /// Time on lanes as a multiple of that at scan speed; at first, what is usual among trees.
    double pace() const { return (flown_ + usual_pace * usual_weight) / (planned_ + usual_weight); }

private:
    static constexpr double usual_pace = 1.16;
    static constexpr Seconds usual_weight{400.0}; ///< as if so much had been flown at the usual pace already

    Seconds flown_{0.0};   ///< on lanes
    Seconds planned_{0.0}; ///< the same at scan speed
    std::optional<Seconds> last_;
    double last_done_m_ = 0.0;
    std::optional<Seconds> estimated_; ///< time of the last estimate
    Seconds end_{0.0};                 ///< its result
};

} // namespace usar::airrobot
