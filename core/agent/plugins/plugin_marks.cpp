#include "core/agent/plugins/plugin_marks.h"

#include <csignal>

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace usar::agent {

namespace {

/// "BYTES MILLISECONDS", the first line of a mark; the others are the process id and the file's name.
QByteArray textOf(const FileStamp& stamp) {
    return QByteArray::number(stamp.bytes) + ' ' + QByteArray::number(stamp.written_ms);
}

/// True if `process` is another process that still runs.
bool othersAreAt(qint64 process) {
    return process > 0 && process != QCoreApplication::applicationPid() && ::kill(static_cast<pid_t>(process), 0) == 0;
}

} // namespace

FileStamp stampOf(const QString& file) {
    const QFileInfo info(file);
    return {info.size(), info.lastModified().toMSecsSinceEpoch()};
}

PluginMarks::PluginMarks(QString folder) : folder_(std::move(folder)) {
    QDir().mkpath(folder_);
}

QString PluginMarks::pathOf(const QString& file) const {
    const QByteArray hash = QCryptographicHash::hash(file.toUtf8(), QCryptographicHash::Sha1).toHex();
    return folder_ + "/loading-" + QString::fromLatin1(hash.left(16));
}

bool PluginMarks::endedTheProgram(const QString& file, const FileStamp& stamp) const {
    if (folder_.isEmpty())
        return false;
    QFile mark(pathOf(file));
    if (!mark.open(QIODevice::ReadOnly))
        return false;
    const QList<QByteArray> lines = mark.readAll().split('\n');
    return lines.size() >= 3 && lines[0] == textOf(stamp) && lines[2] == file.toUtf8() &&
           !othersAreAt(lines[1].toLongLong());
}

void PluginMarks::begin(const QString& file, const FileStamp& stamp) const {
    if (folder_.isEmpty())
        return;
    QFile mark(pathOf(file));
    if (mark.open(QIODevice::WriteOnly | QIODevice::Truncate)) // closed before the plugin's code runs
        mark.write(textOf(stamp) + '\n' + QByteArray::number(QCoreApplication::applicationPid()) + '\n' +
                   file.toUtf8() + '\n');
}

void PluginMarks::end(const QString& file) const {
    if (!folder_.isEmpty())
        QFile::remove(pathOf(file));
}

} // namespace usar::agent
