#include "core/campaign/plan/campaign_writer.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>

#include "core/mission/files/scan_record.h"

namespace usar::campaign {

namespace {

QString pathFrom(const QString& folder, const QString& file) {
    const QString relative = QDir(folder).relativeFilePath(file);
    return relative.startsWith("..") ? file : relative;
}

QJsonArray listOf(const std::vector<std::string>& texts) {
    return QJsonArray::fromStringList(mission::textsOf(texts));
}

QJsonObject seedsOf(const CampaignMission& mission) {
    return {{"first", static_cast<qint64>(mission.first_seed)}, {"count", mission.seeds}};
}

QJsonObject drawsOf(const CampaignMission& mission) {
    QJsonObject draws;
    for (const Draw& draw : mission.draws)
        draws[QString::fromStdString(draw.key)] =
            draw.choices.empty() ? QJsonArray{draw.least, draw.most} : listOf(draw.choices);
    return draws;
}

QJsonObject objectOf(const CampaignMission& mission, const QString& folder) {
    QJsonObject object{{"file", pathFrom(folder, mission.file)}, {"seeds", seedsOf(mission)}};
    if (!mission.name.empty())
        object["name"] = QString::fromStdString(mission.name);
    if (!mission.worlds.empty())
        object["worlds"] = listOf(mission.worlds);
    if (!mission.draws.empty())
        object["draw"] = drawsOf(mission);
    return object;
}

/// A value of KEY=VALUE as JSON: a number or a truth value if it reads as one, else a text.
QJsonValue valueOf(const QString& text) {
    const QJsonArray values = QJsonDocument::fromJson('[' + text.toUtf8() + ']').array();
    const QJsonValue value = values.size() == 1 ? values.first() : QJsonValue(text); // "3, 4" reads as two.
    return value.isDouble() || value.isBool() ? value : QJsonValue(text);
}

QJsonObject objectOf(const Variant& variant, const QString& folder) {
    QJsonObject object{{"name", QString::fromStdString(variant.name)}};
    if (!variant.behavior.empty())
        object["behavior"] = QString::fromStdString(variant.behavior);
    if (!variant.plan.empty())
        object["plan"] = pathFrom(folder, QString::fromStdString(variant.plan));
    QJsonObject values;
    for (const std::string& one : variant.values) {
        const QString text = QString::fromStdString(one);
        values[text.section('=', 0, 0)] = valueOf(text.section('=', 1));
    }
    if (!values.isEmpty())
        object["set"] = values;
    return object;
}

QJsonObject objectOf(const Swarm& swarm) {
    QJsonObject object{{"share", swarm.share}, {"from_s", QJsonArray{swarm.least_s, swarm.most_s}}};
    if (!swarm.kinds.empty())
        object["kinds"] = listOf(swarm.kinds);
    return object;
}

QString wordOf(Keep keep) {
    return keep == Keep::Nothing ? "nothing" : keep == Keep::Everything ? "everything" : "failures";
}

} // namespace

QByteArray writeCampaign(const Campaign& campaign, const QString& folder) {
    QJsonArray missions, variants;
    for (const CampaignMission& mission : campaign.missions)
        missions << objectOf(mission, folder);
    for (const Variant& variant : campaign.variants)
        variants << objectOf(variant, folder);
    QJsonObject root{{"name", QString::fromStdString(campaign.name)},
                     {"missions", missions},
                     {"variants", variants},
                     {"wall_limit_s", campaign.wall_limit_s},
                     {"keep", wordOf(campaign.keep)}};
    if (!campaign.faults.empty())
        root["faults"] = listOf(campaign.faults);
    if (campaign.swarm)
        root["swarm"] = objectOf(*campaign.swarm);
    if (!campaign.again_file.isEmpty())
        root["again"] = pathFrom(folder, campaign.again_file);
    if (campaign.limit_h)
        root["limit_h"] = *campaign.limit_h;
    return QJsonDocument(root).toJson();
}

Result<void> writeWhole(const QString& path, const QByteArray& text) {
    const QString folder = QFileInfo(path).absolutePath();
    if (!QDir().mkpath(folder))
        return failure("the folder cannot be made", folder.toStdString(), "Choose another folder");
    const auto unwritten = [&](const QFileDevice& file) {
        return failure("cannot be written: " + file.errorString().toStdString(), path.toStdString(),
                       "Choose another folder, or make room");
    };
    if (const QFileInfo there(path); there.exists() && !there.isFile() && !there.isDir()) {
        QFile device(path); // A device or a pipe is written to; a file in its place would only hide it.
        if (device.open(QIODevice::WriteOnly | QIODevice::Unbuffered) && device.write(text) == text.size())
            return {};
        return unwritten(device);
    }
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit())
        return {};
    return unwritten(file);
}

} // namespace usar::campaign
