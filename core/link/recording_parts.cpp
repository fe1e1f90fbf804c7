#include "core/link/recording_parts.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include "core/base/numbers.h"

namespace usar::link {

namespace {

/// The name in front of the suffix, and the suffix with its dot.
std::pair<QString, QString> stemAndSuffix(const QString& path) {
    const QString suffix = QFileInfo(path).suffix();
    const qsizetype after_stem = suffix.isEmpty() ? path.size() : path.size() - suffix.size() - 1;
    return {path.left(after_stem), path.mid(after_stem)};
}

/// Renames a file, but over no other one.
bool renameTo(const QString& from, const QString& to) {
    const QByteArray old_name = from.toLocal8Bit();
    const QByteArray new_name = to.toLocal8Bit();
    if (::renameat2(AT_FDCWD, old_name.constData(), AT_FDCWD, new_name.constData(), RENAME_NOREPLACE) == 0)
        return true;
    const bool unknown_here = errno == EINVAL || errno == ENOSYS; // As on some network file systems.
    if (!unknown_here)
        return false;
    if (QFileInfo::exists(to)) {
        errno = EEXIST;
        return false;
    }
    return ::rename(old_name.constData(), new_name.constData()) == 0;
}

bool areAtOnePlace(const struct stat& a, const struct stat& b) {
    return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

/// An inode alone would not do, for a new file may get that of a deleted one.
bool isSameFile(const struct stat& a, const struct stat& b) {
    return areAtOnePlace(a, b) && a.st_size == b.st_size && a.st_mtim.tv_sec == b.st_mtim.tv_sec &&
           a.st_mtim.tv_nsec == b.st_mtim.tv_nsec;
}

} // namespace

QString partPath(const QString& path, int number) {
    const auto [stem, suffix] = stemAndSuffix(path);
    return QStringLiteral("%1.part%2%3").arg(stem, QString::number(number), suffix);
}

std::optional<PartName> readPartPath(const QString& path) {
    static const QRegularExpression mark(QStringLiteral("\\.part([1-9][0-9]{0,8})$"));
    const auto [stem, suffix] = stemAndSuffix(path);
    if (const auto found = mark.match(stem); found.hasMatch())
        return PartName{stem.left(found.capturedStart()) + suffix, found.captured(1).toInt()};
    // Without a suffix of its own, the mark is the suffix.
    if (const auto found = mark.match(path); found.hasMatch())
        return PartName{path.left(found.capturedStart()), found.captured(1).toInt()};
    return std::nullopt;
}

std::vector<int> partNumbersBeside(const QString& path) {
    const QFileInfo place(path);
    std::vector<int> numbers;
    for (const QString& name : place.absoluteDir().entryList(QDir::Files | QDir::Hidden))
        if (const auto part = readPartPath(name); part && part->recording == place.fileName())
            numbers.push_back(part->number);
    std::ranges::sort(numbers);
    return numbers;
}

std::string megabytesText(std::uint64_t bytes) {
    return fixed(static_cast<double>(bytes) / 1e6, 1) + " MB";
}

bool PartSeam::repeats(const Record& record) {
    const bool is_first = !std::exchange(begun_, true);
    if (record.kind == RecordKind::Start) {
        repeating_ = !is_first;
        line_ = record.line;
        return repeating_;
    }
    if (!repeating_)
        return false;
    const bool is_last = record.kind == RecordKind::Note && record.name == part_topic;
    if (is_last || record.line > line_) // Damage may have cost the note.
        repeating_ = false;
    return repeating_ || is_last;
}

Result<RecordingParts> RecordingParts::at(const QString& path) {
    if (const std::vector<int> found = partNumbersBeside(path); !found.empty())
        return failure("this is a part of another recording of that name, and it is left alone",
                       partPath(path, found.front()).toStdString(), "Give the recording another name");
    return RecordingParts(path);
}

bool RecordingParts::isFull(std::uint64_t newest_bytes, std::uint64_t head_bytes, std::uint64_t limit_bytes) {
    return newest_bytes >= std::max(limit_bytes / parts_in_limit, 2 * head_bytes);
}

Result<void> RecordingParts::setAside(int file, std::uint64_t newest_bytes, Seconds end) {
    const QString aside = partPath(path_, number_);
    struct stat status = {}, there = {};
    if (::fstat(file, &status) != 0 || ::lstat(path_.toLocal8Bit().constData(), &there) != 0)
        return failure(std::string("the part cannot be found where it was written: ") + std::strerror(errno),
                       path_.toStdString(), "Leave a recording in its place while it is being written");
    if (!areAtOnePlace(status, there))
        return failure("this is another file than the part that was written there, and it is left alone",
                       path_.toStdString(), "Leave a recording in its place while it is being written");
    if (!renameTo(path_, aside)) {
        const bool in_the_way = errno == EEXIST;
        return failure(in_the_way ? "there is a file of this name already, and it is left alone"
                                  : std::string("the part cannot be renamed: ") + std::strerror(errno),
                       aside.toStdString(), "Give the recording another name, or record to another folder");
    }
    older_.push_back({aside, status, newest_bytes, end});
    older_bytes_ += newest_bytes;
    ++number_;
    return {};
}

void RecordingParts::noteClosed() {
    if (older_.empty())
        return;
    Older& newest = older_.back();
    struct stat status = {};
    if (::lstat(newest.path.toLocal8Bit().constData(), &status) == 0 && areAtOnePlace(status, newest.status))
        newest.status = status; // Otherwise somebody else's file is there, which makeRoom leaves alone.
}

Result<void> RecordingParts::takeBack() {
    if (older_.empty())
        return {};
    const Older& newest = older_.back();
    if (!renameTo(newest.path, path_))
        return failure(std::string("its newest part cannot get its name back: ") + std::strerror(errno),
                       newest.path.toStdString(), "Open it under this name");
    older_bytes_ -= newest.bytes;
    older_.pop_back();
    --number_;
    return {};
}

std::optional<Result<RecordingParts::Dropped>> RecordingParts::makeRoom(std::uint64_t newest_bytes,
                                                                        std::uint64_t limit_bytes) {
    const std::uint64_t next_part = limit_bytes / parts_in_limit;
    if (older_.empty() || bytes(std::max(newest_bytes, next_part)) <= limit_bytes)
        return std::nullopt;
    const Older oldest = std::move(older_.front());
    older_.pop_front();
    older_bytes_ -= oldest.bytes;
    const QByteArray name = oldest.path.toLocal8Bit();
    struct stat status = {};
    const bool there = ::lstat(name.constData(), &status) == 0;
    if (there && !isSameFile(status, oldest.status))
        return failure("this is another file than the part that was written there, and it is left alone",
                       oldest.path.toStdString(), "Look whether you need it");
    if (there && ::unlink(name.constData()) != 0)
        return failure(std::string("the oldest part cannot be deleted to keep the limit: ") + std::strerror(errno),
                       oldest.path.toStdString(), "Delete it by hand");
    return Dropped{oldest.path.toStdString(), there, oldest.bytes, oldest.end};
}

} // namespace usar::link
