// When in a replay the protocol clock said what: the way from a moment of the robot's to a moment of its recording.
#pragma once

#include <optional>
#include <vector>

#include "core/base/clock.h"
#include "core/link/recording_format.h"

namespace usar::link {

/// A replay runs as the protocol clock does, but for pauses, slow stretches and clocks that began anew. Kept are the
/// stretches in which the two go together to within 5 ms: one for a flight at full speed, one for each tick at worst.
class ClockTable {
public:
    /// In the order of the recording; `play` by PlayClock.
    void add(RecordTime play, Seconds now);
    /// Recording time at which the clock read `now`; the last one if it read that twice; clamped to the ends. Nothing
    /// if the clock was never read.
    std::optional<RecordTime> at(Seconds now) const;

private:
    struct Stretch {
        Seconds begin{0.0}; ///< protocol clock, likewise `end`
        Seconds end{0.0};
        RecordTime play{0}; ///< at `begin`
    };
    std::vector<Stretch> stretches_;
};

} // namespace usar::link
