// Maps moments of the protocol clock (the robot's time) to moments of the replay of its recording.
#pragma once

#include <optional>
#include <vector>

#include "core/base/clock.h"
#include "core/link/recording_format.h"

namespace usar::link {

/// A replay advances with the protocol clock, except in pauses, in slow stretches and when the clock started again. The
/// table keeps the stretches in which both agree to within 5 ms: one for a flight at full speed, one per tick at worst.
class ClockTable {
public:
    /// Adds one reading: at replay time `play` (by PlayClock) the protocol clock read `now`. To be called in the order
    /// of the recording. A `now` that is not a number or beyond 1e9 s is ignored.
    void add(RecordTime play, Seconds now);
    /// Replay time (by PlayClock) at which the protocol clock read `now`; the last such time if there are several;
    /// clamped to the first and last reading. Nullopt if no reading was added.
    std::optional<RecordTime> at(Seconds now) const;

private:
    /// The protocol clock from `begin` to `end` without a jump; `play` is the replay time at `begin`.
    struct Stretch {
        Seconds begin{0.0};
        Seconds end{0.0};
        RecordTime play{0};
    };
    std::vector<Stretch> stretches_;
};

} // namespace usar::link
