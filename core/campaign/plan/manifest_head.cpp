#include "core/campaign/plan/manifest_head.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>

#include "core/campaign/plan/manifest.h"

namespace usar::campaign {

Result<QJsonObject> readManifestHead(const QString& folder) {
    QFile file(QDir(folder).filePath(manifest_file));
    if (!file.open(QIODevice::ReadOnly))
        return failure("this folder holds no campaign: " + file.errorString().toStdString(),
                       file.fileName().toStdString(), "Give a folder that usar-mission campaign has written");
    const QJsonObject head = QJsonDocument::fromJson(file.readLine()).object();
    if (!head["variants"].isArray())
        return failure("this is no manifest of a campaign", file.fileName().toStdString() + ":1",
                       "Give a folder that usar-mission campaign has written");
    return head;
}

} // namespace usar::campaign
