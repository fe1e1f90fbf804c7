// A mission that ships, run by usar-mission with other parameters, and what came of it.
#pragma once

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace usar::test {

struct EndedMission {
    int exit_code = -1;
    QJsonObject summary;
    QByteArray said; ///< all of it
};

/// `name` is that of a file in resources/missions, without its ending; `parameters` take the place of the file's.
inline EndedMission runShipped(const QString& name, const QJsonObject& parameters, const QStringList& options = {}) {
    QFile shipped(QString(USAR_SOURCE_DIR "/resources/missions/%1.json").arg(name));
    QTemporaryDir folder;
    QFile file(folder.filePath("mission.json"));
    if (!shipped.open(QIODevice::ReadOnly) || !file.open(QIODevice::WriteOnly))
        return {};
    QJsonObject mission = QJsonDocument::fromJson(shipped.readAll()).object();
    mission["parameters"] = parameters;
    file.write(QJsonDocument(mission).toJson());
    file.close();
    QProcess process;
    process.start(USAR_BINARY_DIR "/bin/usar-mission",
                  QStringList{"run", file.fileName(), "--seed", "2", "--out", folder.filePath("out")} + options);
    if (!process.waitForFinished(110000))
        process.kill();
    const QByteArray out = process.readAllStandardOutput();
    return {process.exitCode(), QJsonDocument::fromJson(out).object(), out + process.readAllStandardError()};
}

} // namespace usar::test
