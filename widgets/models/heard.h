// When something was heard last, and whether that is too long ago to be shown as if it were live.
#pragma once

#include <algorithm>
#include <optional>

#include "core/base/clock.h"
#include "core/protocol/silence.h"

namespace usar::widgets {

/// Times on the protocol clock. A reading is stale once it is older than protocol::silence::reading and than three of
/// its own periods, because some sensors are slow by design. A plain value.
struct Heard {
    Seconds last{0.0};
    /// Smoothed; nullopt before the second arrival.
    std::optional<Seconds> period{};

    /// Takes the time of a new reading. Two readings of one moment count as one.
    void arrived(Seconds at) {
        const Seconds step = at - last;
        if (heard_ && step > Seconds(0.0))
            period = period ? *period + 0.2 * (step - *period) : step;
        heard_ = true;
        last = at;
    }
    /// True if nobody vouches for the reading any more. Never true of what was never heard.
    bool stale(Seconds now) const {
        return heard_ && now - last > std::max(protocol::silence::reading, 3.0 * period.value_or(Seconds(0.0)));
    }
    Seconds age(Seconds now) const { return std::max(Seconds(0.0), now - last); }

private:
    bool heard_ = false;
};

} // namespace usar::widgets
