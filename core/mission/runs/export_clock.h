// The time line of an exported recording: the protocol clock, without its steps backward.
#pragma once

#include <cstdint>
#include <optional>

#include "core/base/clock.h"
#include "core/mission/files/mcap_writer.h"

namespace usar::mission {

/// Nanoseconds on the clock of the server that was connected first. Where a later clock begins at an earlier time, as
/// after a restart of the server, it is moved so that the line goes on where it was. A reading that leaps by more than
/// ten seconds, either way, is believed when the next one agrees with it: until then it counts as damaged.
class ExportClock {
public:
    /// `begin`: what the clock read first.
    explicit ExportClock(Seconds begin);

    /// The next reading may be that of another clock.
    void beginConnection() { is_new_ = true; }
    /// Takes the time that a line tells.
    void take(Seconds reading);

    /// Times of a message that tells this time of its own; without one, or with one that cannot be, it gets that of the
    /// newest line.
    McapTimes timesOf(std::optional<Seconds> own) const;
    /// The newest time on the line.
    Seconds now() const { return onLine(newest_); }

private:
    /// Where a reading of the clock that runs now is on the line, which ends before nanoseconds do.
    Seconds onLine(Seconds reading) const;
    void goOnAt(Seconds reading);

    Seconds newest_; ///< reading of the clock that runs now
    Seconds shift_{0.0};
    std::optional<Seconds> doubted_;
    bool is_new_ = false;
};

} // namespace usar::mission
