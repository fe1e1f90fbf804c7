#include "widgets/plan/editor/plan_file.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include "core/posh/language/token.h"

namespace usar::widgets {

namespace {

constexpr int keep_after_ms = 1000;
constexpr int look_after_ms = 150; ///< other programs write in several steps
const QByteArray byte_order_mark("\xef\xbb\xbf");

Result<QByteArray> readAll(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure("it cannot be read: " + file.errorString().toStdString(), path.toStdString(),
                       "choose another file");
    if (file.size() > qint64(posh::longest_plan_bytes))
        return failure("it is longer than 64 MiB, which no plan is", path.toStdString(), "choose another file");
    return file.readAll();
}

std::string textOf(QByteArray bytes) {
    if (bytes.startsWith(byte_order_mark))
        bytes.remove(0, byte_order_mark.size());
    bytes.replace("\r\n", "\n");
    return bytes.toStdString();
}

} // namespace

PlanFile::PlanFile(QObject* parent) : QObject(parent) {
    keep_timer_.setSingleShot(true);
    keep_timer_.setInterval(keep_after_ms);
    connect(&keep_timer_, &QTimer::timeout, this, &PlanFile::writeKept);
    look_timer_.setSingleShot(true);
    look_timer_.setInterval(look_after_ms);
    connect(&look_timer_, &QTimer::timeout, this, &PlanFile::look);
    connect(&watcher_, &QFileSystemWatcher::fileChanged, &look_timer_, qOverload<>(&QTimer::start));
}

Result<void> PlanFile::write(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit())
        return failure("it cannot be written: " + file.errorString().toStdString(), path.toStdString(),
                       "choose another place");
    return {};
}

Result<std::string> PlanFile::open(const QString& path) {
    const auto bytes = readAll(path);
    if (!bytes)
        return tl::unexpected(bytes.error());
    has_mark_ = bytes->startsWith(byte_order_mark);
    has_crlf_ = bytes->contains("\r\n");
    become(path, {}, textOf(*bytes));
    return saved_;
}

Result<void> PlanFile::save(const QString& path, std::string_view text) {
    QByteArray bytes(text.data(), static_cast<qsizetype>(text.size()));
    if (has_crlf_)
        bytes.replace("\n", "\r\n");
    if (has_mark_)
        bytes.prepend(byte_order_mark);
    forgetKept();
    if (const auto written = write(path, bytes); !written) {
        keep(text); // Now the copy is even more important.
        return written;
    }
    become(path, {}, text);
    return {};
}

void PlanFile::startNew(const QString& name, std::string_view text) {
    has_crlf_ = has_mark_ = false;
    become({}, name, text);
}

void PlanFile::become(const QString& path, const QString& new_name, std::string_view text) {
    path_ = path;
    new_name_ = new_name;
    saved_ = text;
    keep_timer_.stop();
    look_timer_.stop();
    if (!watcher_.files().isEmpty())
        watcher_.removePaths(watcher_.files());
    if (!path_.isEmpty())
        watcher_.addPath(path_);
}

QString PlanFile::name() const {
    return path_.isEmpty() ? new_name_ : QFileInfo(path_).fileName();
}

/// Watches the file again, because a file that was replaced is a different one to the watcher.
void PlanFile::look() {
    if (path_.isEmpty())
        return;
    watcher_.addPath(path_);
    const auto bytes = readAll(path_);
    if (!bytes || textOf(*bytes) == saved_)
        return;
    saved_ = textOf(*bytes);
    emit changedOnDisk(saved_);
}

QString PlanFile::keptPath() const {
    const QByteArray key = (path_.isEmpty() ? QStringLiteral("new") : QFileInfo(path_).absoluteFilePath()).toUtf8();
    return QDir(folder_).filePath(
        QString::fromLatin1(QCryptographicHash::hash(key, QCryptographicHash::Sha1).toHex().left(16)) +
        QStringLiteral(".lap"));
}

void PlanFile::keep(std::string_view text) {
    to_keep_ = std::string(text);
    if (!folder_.isEmpty() && !keep_timer_.isActive())
        keep_timer_.start();
}

/// Errors are ignored, because the copy is only a second safeguard.
void PlanFile::writeKept() {
    if (to_keep_ == saved_ || !QDir().mkpath(folder_))
        return;
    static_cast<void>(write(keptPath(), QByteArray::fromStdString(to_keep_)));
}

std::optional<std::string> PlanFile::kept() const {
    if (folder_.isEmpty() || !QFile::exists(keptPath()))
        return std::nullopt;
    const auto bytes = readAll(keptPath());
    return bytes && bytes->toStdString() != saved_ ? std::optional(bytes->toStdString()) : std::nullopt;
}

void PlanFile::forgetKept() {
    keep_timer_.stop();
    if (!folder_.isEmpty())
        QFile::remove(keptPath());
}

} // namespace usar::widgets
