#include "core/mission/files/recording_name.h"

#include <QDir>
#include <QFileInfo>

namespace usar::mission {

QString newRecordingIn(const QString& folder, const QString& robot_name, const QDateTime& now) {
    QString safe = robot_name;
    for (QChar& c : safe)
        if (!c.isLetterOrNumber() && c != '-' && c != '_')
            c = '_';
    const QString stem = safe + '_' + now.toString("yyyy-MM-dd_HH-mm-ss");
    QString name = stem;
    for (int number = 2; QFileInfo::exists(QDir(folder).filePath(name + ".usarrec")); ++number)
        name = stem + '_' + QString::number(number);
    return QDir(folder).filePath(name + ".usarrec");
}

} // namespace usar::mission
