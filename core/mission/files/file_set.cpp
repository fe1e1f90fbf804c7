#include "core/mission/files/file_set.h"

#include <algorithm>
#include <utility>

#include <QDir>
#include <QFile>
#include <QImageWriter>
#include <QLockFile>
#include <QRegularExpression>

namespace usar::mission {

namespace {

/// Quality on Qt's scale, which means zlib level 3; the default takes three times as long to save a tenth of the size.
constexpr int fast_compression = 66;

/// Bytes between two looks at whether to stop.
constexpr qsizetype part_size = qsizetype(1) << 20;

QString fileNamePart(const std::string& name, const QString& fallback) {
    static const QRegularExpression unwanted("[^A-Za-z0-9-]+");
    const QString part = QString::fromStdString(name).replace(unwanted, "-").left(40);
    return part.contains(QRegularExpression("[A-Za-z0-9]")) ? part : fallback;
}

/// A file that takes nothing more once a stop is requested.
class StoppableFile : public QSaveFile {
public:
    StoppableFile(const QString& path, std::stop_token stop) : QSaveFile(path), stop_(std::move(stop)) {}

protected:
    qint64 writeData(const char* data, qint64 size) override {
        return stop_.stop_requested() ? -1 : QSaveFile::writeData(data, size);
    }

private:
    std::stop_token stop_;
};

bool writeAll(QSaveFile& file, const char* data, qsizetype size) {
    for (qsizetype done = 0; done < size;) {
        const qint64 part = file.write(data + done, std::min(size - done, part_size));
        if (part <= 0)
            return false;
        done += part;
    }
    return true;
}

/// Waits up to a minute while others save into the same folder.
bool waitFor(QLockFile& lock, const std::stop_token& stop) {
    constexpr int longest_ms = 60'000, part_ms = 100;
    for (int waited_ms = 0; waited_ms < longest_ms && !stop.stop_requested(); waited_ms += part_ms)
        if (lock.tryLock(part_ms) || lock.error() != QLockFile::LockFailedError)
            break;
    return lock.isLocked();
}

} // namespace

Error cancelledIn(const QString& folder) {
    return {"saving was cancelled, and nothing of it is left in the folder", folder.toStdString(),
            "The scan is still in memory: save it whenever you like"};
}

QString freeStem(const QString& folder, const ScanRecord& record) {
    const QString base =
        QString("USAR_Scan_%1_%2").arg(fileNamePart(record.level, "map"), fileNamePart(record.robot_name, "robot"));
    for (int number = 1;; ++number) {
        const QString stem = QString("%1_%2").arg(base).arg(number, 3, 10, QChar('0'));
        if (QDir(folder).entryList({stem + ".*", stem + "_*"}, QDir::Files | QDir::Hidden).isEmpty())
            return stem;
    }
}

Result<QStringList> withLockedFolder(const QString& folder, const std::stop_token& stop,
                                     const std::function<Result<QStringList>()>& write) {
    if (folder.isEmpty() || !QDir().mkpath(folder))
        return failure("cannot create the folder for the results", folder.toStdString(), folder_mend);
    // Held until everything is written: two scans that end at the same time must not take the same free number.
    QLockFile lock(QDir(folder).filePath(".usar_scan.lock"));
    lock.setStaleLockTime(0);
    if (!waitFor(lock, stop) && stop.stop_requested())
        return tl::unexpected(cancelledIn(folder));
    if (!lock.isLocked())
        return failure(lock.error() == QLockFile::LockFailedError ? "another program is still saving into the folder"
                                                                  : "cannot write into the folder",
                       folder.toStdString(), folder_mend);
    return write();
}

FileSet::FileSet(QString folder, QString stem, std::stop_token stop)
    : folder_(std::move(folder))
    , stem_(std::move(stem))
    , stop_(std::move(stop)) {}

void FileSet::bytes(const QString& ending, const char* data, qsizetype size) {
    save(ending, [&](QSaveFile& file) { return writeAll(file, data, size); });
}

void FileSet::image(const QString& ending, const QImage& picture) {
    save(ending, [&](QSaveFile& file) {
        QImageWriter writer(&file, "png");
        writer.setQuality(fast_compression);
        return writer.write(picture);
    });
}

void FileSet::stream(const QString& ending, const std::function<bool(const mapping::ByteSink&)>& write) {
    save(ending, [&](QSaveFile& file) {
        return write(
            [&file](const char* data, std::size_t size) { return writeAll(file, data, static_cast<qsizetype>(size)); });
    });
}

QString FileSet::pathOf(const QString& ending) const {
    return QDir(folder_).filePath(stem_ + ending);
}

bool FileSet::stopped() {
    if (!error_ && stop_.stop_requested()) {
        std::ranges::for_each(std::exchange(files_, {}), [](const QString& path) { QFile::remove(path); });
        error_ = cancelledIn(folder_);
    }
    return error_.has_value();
}

void FileSet::save(const QString& ending, const std::function<bool(QSaveFile&)>& write) {
    if (stopped())
        return;
    const QString path = pathOf(ending);
    StoppableFile file(path, stop_);
    if (file.open(QIODevice::WriteOnly) && write(file) && file.commit())
        files_ << path;
    else if (!stopped())
        error_ = Error{"cannot write: " + file.errorString().toStdString(), path.toStdString(), folder_mend};
}

} // namespace usar::mission
