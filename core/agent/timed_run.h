// The common state of behaviors that work for a limited time: clock, state in words, operator's orders, and end.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "core/agent/behavior.h"
#include "core/agent/published.h"

namespace usar::agent {

/// For behaviors with simple orders: Pause stops the robot until Resume, and LandNow ends the behavior. Times are those
/// of the ticks, on the protocol's clock. Owned by one behavior; plain data without a thread or a clock of its own.
/// Call `step` once per tick, before everything else, and check `ending` after it.
struct TimedRun {
    Seconds now{0.0};             ///< time of the newest tick
    std::optional<Seconds> began; ///< time of the first tick
    /// Set by orders; the behavior itself must stop the robot.
    bool paused = false;
    std::string state = "waiting";          ///< in words
    std::optional<BehaviorFinished> ending; ///< set when the behavior is to end

    /// Takes the time of a tick and returns the time since the last one; 0 at the first.
    Seconds step(Seconds tick) {
        const Seconds passed = began ? tick - now : Seconds{0.0};
        now = tick;
        if (!began)
            began = now;
        return passed;
    }
    /// Time since the first tick, including pauses; 0 before it.
    Seconds elapsed() const { return began ? now - *began : Seconds{0.0}; }
    /// True if the behavior has run for `whole` and nothing else has ended it; never true if `whole` is 0.
    bool isOver(Seconds whole) const { return whole > Seconds{0.0} && elapsed() >= whole && !ending; }
    /// Handles an order; returns true.
    bool order(Order order) {
        if (order == Order::LandNow)
            ending = {false, "A person asked the robot to stop."};
        else
            paused = order == Order::Pause;
        return true;
    }
    /// The status, with progress and remaining time if `whole` is not 0.
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
