// Notices that a goal does not come nearer: the thesis's stuckWatch (4.3).
#pragma once

#include <optional>

#include "core/base/clock.h"
#include "core/base/geometry.h"

namespace usar::airrobot {

/// Owned by one robot; told once a tick.
class StuckWatch {
public:
    /// `hindered`: evading, enclosed or without a way. Another goal, or a metre of progress, starts anew.
    void update(Seconds now, const Vec2& position_m, const Vec2& goal_m, bool hindered);
    void reset();
    /// In place of `update` while the robot waits because it was told to: that time counts for nothing.
    void wait(Seconds now);
    /// Something was done about it; progress is still to be made.
    void clearHindered() { hindered_ = Seconds(0.0); }

    /// Since the last progress.
    Seconds withoutProgress() const { return now_ - progress_at_; }
    /// Hindered time since the last progress.
    Seconds hindered() const { return hindered_; }

private:
    std::optional<Vec2> goal_m_;
    double best_m_ = 0.0;
    Seconds now_{0.0};
    Seconds progress_at_{0.0};
    Seconds hindered_{0.0};
};

} // namespace usar::airrobot
