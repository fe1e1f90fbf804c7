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

/// An inode alone would not do, for a new file may get that of a deleted one.
bool isSameFile(const struct stat& a, const struct stat& b) {
    return a.st_dev == b.st_dev && a.st_ino == b.st_ino && a.st_size == b.st_size &&
           a.st_mtim.tv_sec == b.st_mtim.tv_sec && a.st_mtim.tv_nsec == b.st_mtim.tv_nsec;
}

} // namespace

QString partPath(const QString& path, int number) {
    const auto [stem, suffix] = stemAndSuffix(path);
    return QStringLiteral("%1.part%2%3").arg(stem, QString::number(number), suffix);
}

QString recordingOfPart(const QString& path) {
    static const QRegularExpression part(QStringLiteral("\\.part[1-9][0-9]{0,8}(?=(\\.[^./]*)?$)"));
    return QString(path).remove(part);
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
    const QFileInfo place(path);
    const auto [stem, suffix] = stemAndSuffix(place.fileName());
    const QRegularExpression part(QRegularExpression::anchoredPattern(
        QRegularExpression::escape(stem) + "\\.part[1-9][0-9]*" + QRegularExpression::escape(suffix)));
    const QStringList names = place.absoluteDir().entryList(QDir::Files | QDir::Hidden);
    const auto found = std::ranges::find_if(names, [&](const QString& name) { return part.match(name).hasMatch(); });
    if (found != names.end())
        return failure("this is a part of another recording of that name, and it is left alone",
                       place.absoluteDir().filePath(*found).toStdString(), "Give the recording another name");
    return RecordingParts(path);
}

bool RecordingParts::isFull(std::uint64_t newest_bytes, std::uint64_t head_bytes, std::uint64_t limit_bytes) {
    return newest_bytes >= std::max(limit_bytes / parts_in_limit, 2 * head_bytes);
}

Result<void> RecordingParts::setAside(std::uint64_t newest_bytes, Seconds end) {
    const QString aside = partPath(path_, number_);
    struct stat status = {};
    if (::stat(path_.toLocal8Bit().constData(), &status) != 0 || !renameTo(path_, aside)) {
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

void RecordingParts::takeBack() {
    if (older_.empty() || !renameTo(older_.back().path, path_))
        return;
    older_bytes_ -= older_.back().bytes;
    older_.pop_back();
    --number_;
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
    const bool there = ::stat(name.constData(), &status) == 0;
    if (there && !isSameFile(status, oldest.status))
        return failure("this is another file than the part that was written there, and it is left alone",
                       oldest.path.toStdString(), "Look whether you need it");
    if (there && ::unlink(name.constData()) != 0)
        return failure(std::string("the oldest part cannot be deleted to keep the limit: ") + std::strerror(errno),
                       oldest.path.toStdString(), "Delete it by hand");
    return Dropped{oldest.path.toStdString(), oldest.bytes, oldest.end};
}

} // namespace usar::link
