#include "app/locations.h"

#include <QCoreApplication>
#include <QDir>

namespace usar::app {

namespace {

/// First of the candidates, relative to the program's folder, that exists; else the first.
QString firstFolder(const QStringList& candidates) {
    const QDir bin(QCoreApplication::applicationDirPath());
    for (const QString& candidate : candidates)
        if (bin.exists(candidate))
            return QDir::cleanPath(bin.absoluteFilePath(candidate));
    return QDir::cleanPath(bin.absoluteFilePath(candidates.first()));
}

QString worldsFolder() {
    return firstFolder({"../share/worlds", "../share/usar-mission-control/worlds"});
}

} // namespace

QString worldFolder(const QString& name_or_folder) {
    const QDir worlds(worldsFolder());
    const bool is_name = !name_or_folder.contains('/') && worlds.exists(name_or_folder);
    return is_name || !QDir(name_or_folder).exists() ? worlds.absoluteFilePath(name_or_folder) : name_or_folder;
}

QStringList worldNames() {
    return QDir(worldsFolder()).entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name);
}

QStringList pluginFolders() {
    return {firstFolder({"../robots", "../lib/usar-mission-control/robots"})};
}

} // namespace usar::app
