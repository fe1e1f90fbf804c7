// Files that a window is given to open, and those that it leaves.
#pragma once

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>

/// A file of this text; its path, or nothing where it cannot be written.
inline QString fileIn(const QTemporaryDir& folder, const QString& name, const QByteArray& text) {
    QFile file(folder.filePath(name));
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size() ? file.fileName() : QString();
}

/// Names of the files with this ending.
inline QStringList filesIn(const QString& folder, const QString& ending) {
    return QDir(folder).entryList({"*" + ending}, QDir::Files);
}

/// A small scan that the AirRobot's plan decides.
inline QString plannedMission(const QTemporaryDir& folder) {
    return fileIn(folder, "planned.json",
                  R"({ "name": "Planned", "world": "tall_test", "robot": "USARBot.AirRobot", "start": "PlayerStart",
        "behavior": "airrobot/posh", "area": { "x": -10, "y": -10, "width": 20, "height": 20 } })");
}
