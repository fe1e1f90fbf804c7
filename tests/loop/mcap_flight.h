// A small flight of the program `usar-mission`, recorded and exported as MCAP by it.
#pragma once

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QString>

namespace usar::loop {

inline const QString program = QString(USAR_BINARY_DIR) + "/bin/usar-mission";

/// Flies the quick scan of a smaller area into r.usarrec in the folder, beside its mission small.json.
inline bool flySmallMission(const QString& folder) {
    QFile mission(USAR_SOURCE_DIR "/resources/missions/quick_scan.json"), file(folder + "/small.json");
    if (!mission.open(QIODevice::ReadOnly) || !file.open(QIODevice::WriteOnly))
        return false;
    QJsonObject small = QJsonDocument::fromJson(mission.readAll()).object();
    small["area"] = QJsonObject{{"x", -8}, {"y", -8}, {"width", 16}, {"height", 16}};
    file.write(QJsonDocument(small).toJson());
    file.close();
    QProcess process;
    process.start(program, {"run", file.fileName(), "--out", folder + "/out", "--record", folder + "/r.usarrec"});
    return process.waitForFinished(110'000) && process.exitCode() == 0;
}

/// Empty if all is well, "incomplete" if the recording is, otherwise what the program says.
inline QString exportMcap(const QString& recording, const QString& file) {
    QProcess process;
    process.start(program, {"recording-to-mcap", recording, file});
    if (!process.waitForFinished(110'000))
        return "it hangs";
    const QString said = process.readAllStandardError();
    return process.exitCode() == 0 ? said : process.exitCode() == 1 ? QString("incomplete") : "refused: " + said;
}

} // namespace usar::loop
