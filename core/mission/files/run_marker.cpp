#include "core/mission/files/run_marker.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QUuid>

namespace usar::mission {

namespace {

const QString lock_ending = ".lock";
const QString list_ending = ".txt";

/// A folder for the marks, which is there from now on if that is possible.
QString made(const QString& folder) {
    QDir().mkpath(folder);
    return folder;
}

QStringList linesOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()).split(u'\n', Qt::SkipEmptyParts)
                                          : QStringList();
}

} // namespace

RunMarker::RunMarker(const QString& folder)
    : stem_(QDir(made(folder)).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces)))
    , process_(stem_ + lock_ending) {
    process_.setStaleLockTime(0); // However long the program runs, it runs.
    process_.tryLock(0);
}

RunMarker::~RunMarker() {
    QFile::remove(stem_ + list_ending);
}

void RunMarker::setRecordings(const QStringList& paths) const {
    QSaveFile file(stem_ + list_ending);
    if (file.open(QIODevice::WriteOnly) && file.write(paths.join(u'\n').toUtf8()) >= 0)
        file.commit();
}

QStringList RunMarker::takeAbandoned(const QString& folder) {
    QStringList recordings;
    for (const QFileInfo& mark : QDir(folder).entryInfoList({"*" + lock_ending}, QDir::Files, QDir::Time)) {
        QLockFile process(mark.filePath());
        process.setStaleLockTime(0);
        if (!process.tryLock(0))
            continue; // It still runs.
        const QString list = mark.path() + "/" + mark.completeBaseName() + list_ending;
        for (const QString& path : linesOf(list))
            if (QFileInfo::exists(path))
                recordings << path;
        QFile::remove(list);
    }
    return recordings;
}

} // namespace usar::mission
