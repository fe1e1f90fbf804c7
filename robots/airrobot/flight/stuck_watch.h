// Notices when the robot makes no progress toward its goal: the thesis's stuckWatch (4.3).
#pragma once

#include <optional>

#include "core/base/clock.h"
#include "core/base/geometry.h"

namespace usar::airrobot {

/// Distances are beelines, so a detour that leads away from the goal is no progress. Owned by one robot; call `update`
/// or `wait` once per tick. Positions are in the map frame.
class StuckWatch {
public:
    /// `hindered` means that the robot is evading, enclosed or has no open direction. Another goal (farther than half a
    /// meter from the last one), or progress of one meter, restarts both times.
    void update(Seconds now, const Vec2& position_m, const Vec2& goal_m, bool hindered) {
        const double distance_m = (goal_m - position_m).norm();
        const Seconds step = goal_m_ ? now - now_ : Seconds(0.0);
        now_ = now;
        if (!goal_m_ || (*goal_m_ - goal_m).norm() > 0.5 || distance_m < best_m_ - 1.0) {
            goal_m_ = goal_m;
            best_m_ = distance_m;
            progress_at_ = now;
            hindered_ = Seconds(0.0);
        } else if (hindered) {
            hindered_ += step;
        }
    }
    /// Forgets the goal and both times.
    void reset() { *this = {}; }
    /// Replaces `update` while the robot waits on purpose; this time does not count.
    void wait(Seconds now) {
        if (!goal_m_)
            return;
        progress_at_ += now - now_;
        now_ = now;
    }
    /// Restarts only the hindered time, because a maneuver may have solved the problem.
    void clearHindered() { hindered_ = Seconds(0.0); }

    /// Time since the last progress, or since the goal was set; 0 without a goal.
    Seconds withoutProgress() const { return now_ - progress_at_; }
    /// Time since the last progress during which the robot was hindered.
    Seconds hindered() const { return hindered_; }

private:
    /// The goal of the last `update` that restarted the times; nullopt before the first.
    std::optional<Vec2> goal_m_;
    double best_m_ = 0.0; ///< distance to the goal at the last progress
    /// Time of the last `update` or `wait`.
    Seconds now_{0.0};
    /// Time of the last progress, moved on by the time spent waiting.
    Seconds progress_at_{0.0};
    Seconds hindered_{0.0};
};

} // namespace usar::airrobot
