// Reads a recording in order or from any moment on, even if the file is damaged.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <QString>

#include "core/base/result.h"
#include "core/link/recording_chain.h"

namespace usar::link {

/// A recording may be in parts (recording-format.md, "Parts"). The file that is opened and the parts before it are then
/// read as one recording, as far back as they lie beside it, and times count from the first of them. If the file has
/// nothing in it that can be read, those are read alone.
///
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
    /// Offset in the file at which the record last returned by `next` begins, or the block that holds it. The files of
    /// all parts count as one.
    std::uint64_t offset() const { return parts_[now_].begin_bytes + parts_[now_].source->offset(); }
    /// Makes `next` return the first record that is not earlier than `time`.
    void seek(RecordTime time);

private:
    explicit RecordingReader(RecordingChain chain, std::string path);
    /// Makes this part the one that is read.
    void goTo(std::size_t part);
    void addDamage(const RecordingDamage& piece);

    std::string path_;
    std::vector<RecordingPart> parts_; ///< in their order; at least one
    std::size_t now_ = 0;              ///< the part that is read
    RecordingSurvey survey_;
    std::vector<RecordingDamage> met_; ///< by the last call of `next`
};

} // namespace usar::link
