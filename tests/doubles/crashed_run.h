// The traces that a killed program leaves behind.
#pragma once

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include "core/mission/files/run_marker.h"

namespace usar::doubles {

/// Leaves the mark of a process that recorded to these files and is gone; false if that cannot be done.
inline bool leaveAsIfKilled(const QString& marks_folder, const QStringList& recordings) {
    QProcess process;
    process.start("true", QStringList());
    if (!process.waitForStarted())
        return false;
    const QByteArray gone = QByteArray::number(process.processId());
    process.waitForFinished();
    const QTemporaryDir living;
    const mission::RunMarker marker(living.path());
    marker.setRecordings(recordings);
    bool left = QDir().mkpath(marks_folder);
    for (const QFileInfo& mark : QDir(living.path()).entryInfoList(QDir::Files)) {
        QFile from(mark.filePath());
        QFile to(QDir(marks_folder).filePath(mark.fileName()));
        left = left && from.open(QIODevice::ReadOnly) && to.open(QIODevice::WriteOnly);
        QByteArray text = from.readAll();
        if (mark.suffix() == "lock") // Its first line is the number of the process.
            text.replace(0, text.indexOf('\n'), gone);
        left = left && to.write(text) == text.size();
    }
    return left;
}

} // namespace usar::doubles
