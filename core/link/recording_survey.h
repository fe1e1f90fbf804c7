// What a recording holds, counted record by record while it is written or read.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/byte_codec.h"
#include "core/link/play_clock.h"
#include "core/link/recording_format.h"

namespace usar::link {

/// A stretch of the file that holds no record.
struct RecordingDamage {
    std::uint64_t offset = 0;
    std::uint64_t bytes = 0;
    bool operator==(const RecordingDamage&) const = default;
};

/// A file of a recording. Offsets in a recording count over all its files, one behind the other.
struct RecordingPlace {
    std::string file; ///< its name without the folder; empty: unknown
    std::uint64_t offset = 0;
};

/// Overview of the whole file, or of all parts that were found. A recording that was not ended properly is as good as
/// any other, except for what had not been written yet.
struct RecordingSurvey {
    std::map<std::string, std::string> facts; ///< host, port, started, program, and whatever else its writer knew
    RecordTime span{0};                       ///< time of the last record
    RecordTime play_span{0};                  ///< the same by PlayClock: the length of a replay
    std::uint64_t file_bytes = 0;
    std::uint64_t records = 0;
    std::uint64_t bytes_in = 0;
    std::uint64_t bytes_out = 0;
    std::uint64_t commands = 0;          ///< number of Out records
    LineNumber first_line;               ///< newest info line when the recording began
    std::vector<RecordingDamage> damage; ///< in the order of the file
    std::uint64_t tail_lost_bytes = 0;   ///< size of an incomplete record at the end; counted in `damage`, too
    bool ended = false;                  ///< ended properly
    bool being_written = false;          ///< by a running program: later records are not included, and nothing is lost
    ClockTable clock;                    ///< replay time by protocol clock
    int parts_lost = 0;                  ///< parts that came before and are not there
    std::string why_lost;                ///< the reason, which may follow "because"
    std::string later;                   ///< a sentence: this is not the newest part; empty if it is
    std::string not_read;                ///< a sentence: the newest part cannot be read; empty if it can
    std::vector<RecordingPlace> files;   ///< and where in the recording each begins

    /// Adds what the next part of the same recording holds.
    void append(const RecordingSurvey& later);
    /// Sentences for the user about what is missing; empty if nothing is.
    std::string complaint() const;
    /// Those about parts that are not included, which is no damage: the first ones may have been deleted as it was
    /// asked for.
    std::string missingParts() const;
    /// The others: what is damaged, and what broke off.
    std::string defects() const;
    /// The file that has this offset of the recording, and where in it.
    RecordingPlace placeOf(std::uint64_t offset) const;
};

/// Makes the part of a survey that records add up to. Its state can be written down between two records, so that a
/// reader knows what came before without reading it.
class RecordCounter {
public:
    /// To be called with every record in order.
    void take(const Record& record);
    const RecordingSurvey& survey() const { return survey_; }

    /// Appends the state; of the clock table only what has changed since the state was appended last.
    void appendState(std::string& bytes);
    /// Appends the state with the whole clock table.
    void appendWholeState(std::string& bytes) const;
    /// Continues from a state, after the states before it, or from a whole one. Facts and the first line are in no
    /// state and stay as they are. False if the bytes are malformed, and this object is then worthless.
    bool continueFrom(ByteReader& bytes);

private:
    void appendCounts(std::string& bytes) const;
    void takeFacts(std::string_view text);

    RecordingSurvey survey_;
    PlayClock clock_;
    std::size_t noted_stretches_ = 0; ///< of the clock table, that cannot change after the last state
};

} // namespace usar::link
