// Reads a recording in order or from any moment on, even if the file is damaged.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QFile>
#include <QString>

#include "core/base/result.h"
#include "core/link/play_clock.h"
#include "core/link/recording_format.h"

namespace usar::link {

/// A stretch of the file that holds no record.
struct RecordingDamage {
    std::uint64_t offset = 0;
    std::uint64_t bytes = 0;
    bool operator==(const RecordingDamage&) const = default;
};

/// Overview of the whole file. A recording that was not ended properly is as good as any other, except for what had not
/// been written yet.
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

    /// Sentences for the user about what is missing; empty if nothing is.
    std::string complaint() const;
};

/// Surveys the file when it is opened and then reads it through a window of a few MiB, so that the length of a
/// recording costs no memory except an index entry per 64 KiB. Damage costs the records that it hit; the search for the
/// next good record gives up after 64 MiB of false candidates, so a hostile file cannot stall the program. Times never
/// run backward: an earlier time is replaced by the one before it. A file that is still being written is read up to
/// where it ended when it was opened. Used in its owner's thread.
class RecordingReader {
public:
    /// Errors: the file cannot be read, is not a recording, has an unknown version, or holds no whole record.
    static Result<std::unique_ptr<RecordingReader>> open(const QString& path);

    const RecordingSurvey& survey() const { return survey_; }
    const std::string& path() const { return path_; }
    /// Returns the next record, or nullopt at the end. Its texts are valid until the next call.
    std::optional<Record> next() { return find(nullptr); }
    /// Offset in the file at which the record last returned by `next` begins.
    std::uint64_t offset() const { return record_offset_; }
    /// Makes `next` return the first record that is not earlier than `time`.
    void seek(RecordTime time);

private:
    /// Index entry: a record's time and its offset in the file.
    struct Entry {
        RecordTime time{0};
        std::uint64_t offset = 0;
    };
    RecordingReader() = default;
    Result<void> readHead();
    /// True while a writer holds its lock on the file.
    bool writerLives();
    void surveyAll();
    void judgeEnd();
    void takeFacts(std::string_view text);
    /// Returns the next whole record from `position_` on, skipping damage; skipped stretches are appended to `damage`.
    /// If that is null, damage that the survey has found is skipped without another search.
    std::optional<Record> find(std::vector<RecordingDamage>* damage);
    /// End of the damage that begins at `position_` by the survey; nullopt if none does.
    std::optional<std::uint64_t> endOfKnownDamage() const;
    /// Offset of the first whole record at or after `offset`; nullopt if there is none or the search gives up.
    std::optional<std::uint64_t> nextWhole(std::uint64_t offset);
    /// Bytes of the file from `offset` on, at least `least` of them if the file has that many. Valid until the next
    /// call.
    std::string_view at(std::uint64_t offset, std::size_t least);

    QFile file_;
    std::string path_;
    RecordingSurvey survey_;
    std::vector<Entry> index_;
    std::string window_;
    std::uint64_t window_offset_ = 0;
    std::uint64_t position_ = 0;
    std::uint64_t record_offset_ = 0;
    std::uint64_t scents_left_bytes_ = 64u << 20; ///< candidate bytes that nextWhole() may still check
    RecordTime newest_{0};
};

} // namespace usar::link
