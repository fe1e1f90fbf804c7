// What every behavior that works for some time keeps: its clock, what it does in words, a person's orders, and its end.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "core/agent/behavior.h"
#include "core/agent/published.h"

namespace usar::agent {

/// For behaviors whose orders are simple: a pause stands, `LandNow` ends. Times are of the protocol clock and come with
/// the ticks; before the first one nothing has begun. Owned by one behavior; a plain value without a thread or a clock
/// of its own. Call `step` once a tick, before all else, and look at `ending` behind it.
struct TimedRun {
    Seconds now{0.0};
    std::optional<Seconds> began; ///< with the first tick
    bool paused = false;
    std::string state = "waiting"; ///< in words
    std::optional<BehaviorFinished> ending;

    /// The time since the last tick; none at the first.
    Seconds step(Seconds tick) {
        const Seconds passed = began ? tick - now : Seconds{0.0};
        now = tick;
        if (!began)
            began = now;
        return passed;
    }
    Seconds elapsed() const { return began ? now - *began : Seconds{0.0}; }
    /// Whether the behavior has had its time and nothing else has ended it; `whole` of 0 never ends.
    bool isOver(Seconds whole) const { return whole > Seconds{0.0} && elapsed() >= whole && !ending; }
    /// True: it has been seen to.
    bool order(Order order) {
        if (order == Order::LandNow)
            ending = {false, "A person asked the robot to stop."};
        else
            paused = order == Order::Pause;
        return true;
    }
    /// With progress and the time that is left, where there is a whole.
    BehaviorStatus status(Seconds whole, double way_m) const {
        BehaviorStatus status;
        status.time = now;
        status.elapsed = elapsed();
        status.state = state;
        status.distance_flown_m = way_m;
        status.paused = paused;
        if (whole > Seconds{0.0}) {
            status.progress_pct = std::min(100.0, 100.0 * (status.elapsed / whole));
            status.time_left = std::max(Seconds{0.0}, whole - status.elapsed);
        }
        return status;
    }
};

} // namespace usar::agent
