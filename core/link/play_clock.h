// Determines when to replay each record of a recording: as it arrived, but no faster than the robot's own clock ran;
// and finds moments of the replay by that clock.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/byte_codec.h"
#include "core/base/clock.h"
#include "core/link/recording_format.h"

namespace usar::link {

/// A simulator at 500 times real time fills a recording of one second with minutes of flight, which nobody could watch.
/// So each connection, and each part of a recording, plays for as long as it lasted, or for as long as the protocol
/// clock says, whichever is longer. Must be fed with every record in order; otherwise a plain value.
class PlayClock {
public:
    /// 73 years. What says to be later is damage, and counts as this, so that times can be added.
    static constexpr RecordTime longest{std::int64_t{1} << 61};
    /// A protocol clock that leaps farther ahead than this, or backward, is damaged or another clock: counting restarts
    /// there.
    static constexpr Seconds longest_leap{10.0};
    /// Readings of the protocol clock beyond this are damage.
    static constexpr Seconds farthest{1e9};

    /// Time from the start of the replay at which to play the record. Never runs backward.
    RecordTime at(const Record& record);
    /// Newest reading of the protocol clock on this connection; nullopt before the first.
    std::optional<Seconds> now() const { return now_; }

    /// Writes down the state between two records.
    void appendTo(std::string& bytes) const;
    /// Continues from such a state; false if the bytes are malformed.
    bool readFrom(ByteReader& bytes);

private:
    /// Restarts counting at the current play time.
    void anchor(RecordTime arrival, std::optional<Seconds> now);

    RecordTime anchor_arrival_{0};
    RecordTime anchor_play_{0};
    std::optional<Seconds> anchor_now_; ///< protocol clock at the anchor
    std::optional<Seconds> now_;        ///< newest protocol clock
    RecordTime play_{0};
};

/// A replay advances with the protocol clock, except in pauses, in slow stretches and when the clock started again. The
/// table keeps the stretches in which both agree to within 5 ms: one for a flight at full speed, one per tick at worst.
class ClockTable {
public:
    /// A damaged recording may claim any number of stretches; those beyond this many are ignored.
    static constexpr std::size_t most_stretches = std::size_t{1} << 20;

    /// Adds one reading: at replay time `play` (by PlayClock) the protocol clock read `now`. Readings come in the
    /// order of the recording. A `now` that is not a number or beyond PlayClock::farthest is ignored.
    void add(RecordTime play, Seconds now);
    /// Replay time (by PlayClock) at which the protocol clock read `now`; the last such time if there are several;
    /// clamped to the first and last reading. Nullopt if no reading was added or `now` is not a number.
    std::optional<RecordTime> at(Seconds now) const;

    /// Adds the readings of a table whose replay time 0 is `begin` in this one, behind all readings of this one.
    void append(const ClockTable& later, RecordTime begin);

    bool operator==(const ClockTable&) const = default;

    /// How many stretches no further reading can change: all but the last.
    std::size_t unchangingStretches() const { return stretches_.empty() ? 0 : stretches_.size() - 1; }
    /// Appends the stretches from the one of this number on.
    void appendTo(std::string& bytes, std::size_t first) const;
    /// Replaces the stretches from the first of those on; false if the bytes are malformed or stretches before them are
    /// missing.
    bool readFrom(ByteReader& bytes);

private:
    /// The protocol clock from `begin` to `end` without a jump; `play` is the replay time at `begin`.
    struct Stretch {
        Seconds begin{0.0};
        Seconds end{0.0};
        RecordTime play{0};
        bool operator==(const Stretch&) const = default;
    };
    std::vector<Stretch> stretches_;
};

} // namespace usar::link
