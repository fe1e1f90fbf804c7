// Determines when to replay each record of a recording: as it arrived, but no faster than the robot's own clock ran.
#pragma once

#include <optional>

#include "core/base/clock.h"
#include "core/link/recording_format.h"

namespace usar::link {

/// A simulator at 500 times real time fills a recording of one second with minutes of flight, which nobody could watch.
/// So each connection plays for as long as it lasted, or for as long as the protocol clock says, whichever is longer.
/// Must be fed with every record in order; otherwise a plain value.
class PlayClock {
public:
    /// Time from the start of the replay at which to play the record. Never runs backward.
    RecordTime at(const Record& record);
    /// Newest reading of the protocol clock on this connection; nullopt before the first.
    std::optional<Seconds> now() const { return now_; }

private:
    /// Restarts counting at the current play time.
    void anchor(RecordTime arrival, std::optional<Seconds> now);

    RecordTime anchor_arrival_{0};
    RecordTime anchor_play_{0};
    std::optional<Seconds> anchor_now_; ///< protocol clock at the anchor
    std::optional<Seconds> now_;        ///< newest protocol clock
    RecordTime play_{0};
};

} // namespace usar::link
