// Reads a recording in order or from any moment on, even if the file is damaged.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <QString>

#include "core/base/result.h"
#include "core/link/recording_source.h"
#include "core/link/recording_survey.h"

namespace usar::link {

/// Quick: a file with an index, or with groups that are whole, is not read before it is played; what is damaged in it
/// joins the survey when `next` meets it.
enum class OpenMode { Thorough, Quick };

/// Surveys the file when it is opened and then reads it through a window of a few MiB, so that the length of a
/// recording costs no memory except an index entry: one per 64 KiB of a file of version 1, one per group of 256 KiB of
/// records in version 2. Damage costs the records that it hit, in a packed file those up to the end of the group. Times
/// never run backward: an earlier time is replaced by the one before it. A file that is still being written is read up
/// to where it ended when it was opened. Used in its owner's thread.
class RecordingReader {
public:
    /// Errors: the file cannot be read, is not a recording, has an unknown version, or holds no whole record.
    static Result<std::unique_ptr<RecordingReader>> open(const QString& path, OpenMode mode = OpenMode::Thorough);

    const RecordingSurvey& survey() const { return survey_; }
    const std::string& path() const { return path_; }
    /// Returns the next record, or nullopt at the end. Its texts are valid until the next call.
    std::optional<Record> next();
    /// Offset in the file at which the record last returned by `next` begins, or the block that holds it.
    std::uint64_t offset() const { return source_->offset(); }
    /// Makes `next` return the first record that is not earlier than `time`.
    void seek(RecordTime time) { source_->seek(time); }

private:
    RecordingReader() = default;
    /// Chooses the source by the version that the head names.
    Result<void> readHead();
    void judgeEnd();
    void addDamage(const RecordingDamage& piece);

    RecordingFile file_;
    std::string path_;
    RecordingSurvey survey_;
    std::unique_ptr<RecordSource> source_;
    std::vector<RecordingDamage> met_; ///< by the last call of `next`
};

} // namespace usar::link
