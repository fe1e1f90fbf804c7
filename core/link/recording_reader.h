// Reads a recording in order or from any moment on, whatever has happened to the file.
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
#include "core/link/clock_table.h"
#include "core/link/recording_format.h"

namespace usar::link {

/// Bytes of the file that make no record.
struct RecordingDamage {
    std::uint64_t offset = 0;
    std::uint64_t bytes = 0;
    bool operator==(const RecordingDamage&) const = default;
};

/// What the whole file holds. A recording that nobody ended is as good as any, but for what was not written yet.
struct RecordingSurvey {
    std::map<std::string, std::string> facts; ///< host, port, started, program, and what else its maker knew
    RecordTime span{0};                       ///< time of the last record
    RecordTime play_span{0};                  ///< the same by PlayClock: how long a replay lasts
    std::uint64_t file_bytes = 0;
    std::uint64_t records = 0;
    std::uint64_t bytes_in = 0;
    std::uint64_t bytes_out = 0;
    std::uint64_t commands = 0; ///< Out records
    LineNumber first_line;      ///< newest line when the recording began
    std::vector<RecordingDamage> damage;
    std::uint64_t tail_lost_bytes = 0; ///< at the end, an incomplete record; counted in `damage`, too
    bool ended = false;                ///< in order
    bool being_written = false;        ///< by a program that lives: what comes later is not here, and nothing is lost
    ClockTable clock;                  ///< when in the replay the protocol clock said what

    /// A sentence for the person about what is missing; empty where nothing is.
    std::string complaint() const;
};

/// Surveys the file when it is opened and then reads it through a window of a few MiB, so the length of a recording
/// costs no memory but an index entry for every 64 KiB. Damage costs the records that it hit; the search for the next
/// good one gives up after 64 MiB of false scents, so a hostile file cannot hold anybody up. Times never run backward:
/// one that does is taken for the one before it. Of a file that is being written it holds what was there when it was
/// opened. Used from its owner's thread.
class RecordingReader {
public:
    static Result<std::unique_ptr<RecordingReader>> open(const QString& path);

    const RecordingSurvey& survey() const { return survey_; }
    const std::string& path() const { return path_; }
    /// The next record; its texts live until the next call. Nothing at the end.
    std::optional<Record> next();
    /// Where the record that `next` gave last begins.
    std::uint64_t offset() const { return record_offset_; }
    /// So that `next` gives the first record that is not earlier than `time`.
    void seek(RecordTime time);

private:
    struct Entry {
        RecordTime time{0};
        std::uint64_t offset = 0;
    };
    RecordingReader() = default;
    Result<void> readHead();
    bool writerLives();
    void surveyAll();
    void judgeEnd();
    void takeFacts(std::string_view text);
    /// The next whole record from `position_` on, over damage; what is passed over goes into `damage` where given.
    std::optional<Record> find(std::vector<RecordingDamage>* damage);
    std::optional<std::uint64_t> nextWhole(std::uint64_t offset);
    /// The file's bytes from there, at least so many where the file has them.
    std::string_view at(std::uint64_t offset, std::size_t least);

    QFile file_;
    std::string path_;
    RecordingSurvey survey_;
    std::vector<Entry> index_;
    std::string window_;
    std::uint64_t window_offset_ = 0;
    std::uint64_t position_ = 0;
    std::uint64_t record_offset_ = 0;
    std::uint64_t scents_left_bytes_ = 64u << 20;
    RecordTime newest_{0};
};

} // namespace usar::link
