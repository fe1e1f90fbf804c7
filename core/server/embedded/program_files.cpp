#include "core/server/embedded/program_files.h"

#include <QCoreApplication>
#include <QDir>
#include <QRegularExpression>

namespace usar::server {

namespace {

/// Returns the first of the candidates (relative to the program's folder) that exists, or else the first one.
QString firstThere(const QStringList& candidates) {
    const QDir bin(QCoreApplication::applicationDirPath());
    for (const QString& candidate : candidates)
        if (bin.exists(candidate))
            return QDir::cleanPath(bin.absoluteFilePath(candidate));
    return QDir::cleanPath(bin.absoluteFilePath(candidates.first()));
}

} // namespace

QString worldsFolder() {
    return firstThere({"../share/worlds", "../share/usar-mission-control/worlds"});
}

std::optional<SeededWorld> seededWorld(const QString& name) {
    static const QRegularExpression pattern("^([a-z_]+):([0-9]{1,9})$");
    const auto parts = pattern.match(name);
    if (!parts.hasMatch())
        return std::nullopt;
    return SeededWorld{parts.captured(1), parts.captured(2).toULongLong()};
}

Result<QString> findWorldIn(const QString& worlds_folder, const QString& name_or_folder) {
    const QDir worlds(worlds_folder);
    if (!name_or_folder.isEmpty() && !name_or_folder.contains('/') && worlds.exists(name_or_folder))
        return worlds.absoluteFilePath(name_or_folder);
    if (QDir(name_or_folder).exists() && !name_or_folder.isEmpty())
        return name_or_folder;
    const QStringList names = worlds.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name);
    const QString mend = names.isEmpty() ? "There is none at all in %1; build or install the program again, or give "
                                           "the path of a world folder"
                                         : "Known in %1 are: " + names.join(", ") +
                                               "; a name and a seed make another one of its kind, such as town:7";
    return failure("there is no such world", "world " + name_or_folder.toStdString(),
                   mend.arg(worlds.absolutePath()).toStdString());
}

Result<QString> findWorld(const QString& name_or_folder) {
    return findWorldIn(worldsFolder(), name_or_folder);
}

QStringList worldNames() {
    const QDir worlds(worldsFolder());
    QStringList names = worlds.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name);
    names.removeIf([&worlds](const QString& name) { return !worlds.exists(name + "/world.sdf"); });
    return names;
}

QString missionsFolder() {
    return firstThere({"../share/missions", "../share/usar-mission-control/missions"});
}

QString campaignsFolder() {
    return firstThere({"../share/campaigns", "../share/usar-mission-control/campaigns"});
}

QString samplesFolder() {
    return firstThere({"../share/samples", "../share/usar-mission-control/samples"});
}

QString robotsFolder() {
    return firstThere({"../share/robots", "../share/usar-mission-control/robots"});
}

QString serverFilesFolder() {
    return robotsFolder() + "/usarsim";
}

QString equipmentAdvice() {
    return QString(
               "A stock robot of a USARSim server lacks some of the sensors of ours. USARBot.ini in %1 has them for "
               "UT2004, and DefaultUSAR.ini for UDK; \"usar-mission server-files\" merges them into the server's "
               "own file, and the page \"Fly it on a real USARSim\" says how.")
        .arg(serverFilesFolder());
}

QString manualPage() {
    return firstThere({"../share/html", "../share/usar-mission-control/html"}) + "/resources/docs/tasks/README.html";
}

QString missionProgram() {
    return firstThere({"usar-mission", "../bin/usar-mission"});
}

QString behaviorHostProgram() {
    return firstThere({"usar-behavior-host", "../bin/usar-behavior-host"});
}

QStringList pluginFolders() {
    return {firstThere({"../robots", "../lib/usar-mission-control/robots"})};
}

QString worldTitle(QString name) {
    name.replace('_', ' ');
    return name.left(1).toUpper() + name.mid(1);
}

} // namespace usar::server
