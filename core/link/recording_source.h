// Where a recording's reader takes its records from: a file of one version of the format or another.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <QFile>
#include <QString>

#include "core/link/recording_survey.h"

namespace usar::link {

/// A file read through a window of a few MiB, up to where it ended when it was opened.
class RecordingFile {
public:
    bool open(const QString& path);
    QString errorString() const { return file_.errorString(); }
    /// True while a writer holds its lock on the file.
    bool writerLives();
    /// Notes how long the file is now.
    void measure();
    std::uint64_t size() const { return size_; }
    /// Bytes of the file from `offset` on, at least `least` of them if the file has that many. Valid until the next
    /// call.
    std::string_view at(std::uint64_t offset, std::size_t least);
    /// Frees the window until the next call of `at`. The file stays open.
    void rest() { std::string().swap(window_); }

private:
    QFile file_;
    std::string window_;
    std::uint64_t window_offset_ = 0;
    std::uint64_t size_ = 0;
};

/// Reads the records of one file, whose head has been read. Damage costs the records that it hit; the search for what
/// is whole again gives up after 64 MiB of false candidates, so a hostile file cannot stall the program. Times never
/// run backward: an earlier time is replaced by the one before it.
class RecordSource {
public:
    virtual ~RecordSource() = default;

    /// Surveys the file; `thoroughly`: also looks for damage that a reader would meet only later.
    virtual RecordingSurvey survey(bool thoroughly) = 0;
    /// The next record; skipped stretches are appended to `damage` unless it is null.
    virtual std::optional<Record> next(std::vector<RecordingDamage>* damage) = 0;
    /// Makes `next` return the first record that is not earlier than `time`.
    virtual void seek(RecordTime time) = 0;
    /// Frees the memory for reading until the next seek, which must come before `next`.
    virtual void rest() { file_.rest(); }
    /// Offset in the file of what held the last record.
    virtual std::uint64_t offset() const = 0;

protected:
    /// Index entry: a record's time, and the offset in the file of what begins with it.
    struct Entry {
        RecordTime time{0};
        std::uint64_t offset = 0;
    };

    explicit RecordSource(RecordingFile& file) : file_(file) {}
    /// Surveys the file by reading every record.
    RecordingSurvey surveyByReading();
    /// Called there for each record.
    virtual void index(const Record&) {}
    /// Makes `next` begin at the entry.
    virtual void goTo(const Entry& entry) = 0;
    /// The last entry before `time`.
    Entry entryBefore(RecordTime time) const;
    /// Returns the first offset of the file whose bytes `whole` accepts. It is asked at each offset from `offset` on
    /// where `size` says something may begin. Nullopt if there is none, or the search gives up. A search that was made
    /// before has its result at once, so that a file can be read again and again as far as its survey came.
    template <class Size, class Whole>
    std::optional<std::uint64_t> search(std::uint64_t offset, std::size_t head_bytes, Size size, Whole whole);

    RecordingFile& file_;
    std::vector<Entry> index_;
    RecordTime newest_{0};

private:
    template <class Size, class Whole>
    std::optional<std::uint64_t> searchAnew(std::uint64_t offset, std::size_t head_bytes, Size size, Whole whole);

    std::uint64_t scents_left_bytes_ = 64u << 20;                    ///< candidate bytes that `search` may still check
    std::map<std::uint64_t, std::optional<std::uint64_t>> searched_; ///< results of `search` by where it began
};

/// Version 1: one plain record behind the other. `file` must outlive the source.
std::unique_ptr<RecordSource> plainSource(RecordingFile& file);
/// Version 2: blocks of compressed records.
std::unique_ptr<RecordSource> packedSource(RecordingFile& file);

template <class Size, class Whole>
std::optional<std::uint64_t> RecordSource::search(std::uint64_t offset, std::size_t head_bytes, Size size,
                                                  Whole whole) {
    const auto known = searched_.find(offset);
    return known != searched_.end() ? known->second : searched_[offset] = searchAnew(offset, head_bytes, size, whole);
}

template <class Size, class Whole>
std::optional<std::uint64_t> RecordSource::searchAnew(std::uint64_t offset, std::size_t head_bytes, Size size,
                                                      Whole whole) {
    for (; offset + head_bytes <= file_.size(); ++offset) {
        const std::optional<std::size_t> bytes = size(file_.at(offset, head_bytes));
        if (!bytes || offset + *bytes > file_.size())
            continue;
        if (*bytes > scents_left_bytes_)
            return std::nullopt;
        scents_left_bytes_ -= *bytes;
        if (whole(file_.at(offset, *bytes)))
            return offset;
    }
    return std::nullopt;
}

} // namespace usar::link
