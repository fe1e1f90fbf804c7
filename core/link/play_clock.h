// When to play what a recording holds: as it arrived, but no faster than the robot lived.
#pragma once

#include <optional>

#include "core/base/clock.h"
#include "core/link/recording_format.h"

namespace usar::link {

/// A simulator at 500 times real time fills a recording of a second with minutes of flight; nobody could watch that.
/// So each connection takes as long as it took, or as long as the protocol clock says, whichever is more. Fed with
/// every record in order; a value otherwise.
class PlayClock {
public:
    /// When to play it, since the beginning. Never runs backward.
    RecordTime at(const Record& record);
    /// What the protocol clock said last on this connection.
    std::optional<Seconds> now() const { return now_; }

private:
    void anchor(RecordTime arrival, std::optional<Seconds> now);

    RecordTime anchor_arrival_{0};
    RecordTime anchor_play_{0};
    std::optional<Seconds> anchor_now_; ///< protocol clock there
    std::optional<Seconds> now_;        ///< the newest one
    RecordTime play_{0};
};

} // namespace usar::link
