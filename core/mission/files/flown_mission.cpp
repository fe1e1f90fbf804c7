#include "core/mission/files/flown_mission.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace usar::mission {

std::string noteOf(const FlownMission& flown, const std::vector<agent::ParameterSpec>& specs) {
    QJsonObject json{{"mission", QJsonDocument::fromJson(writeMission(flown.mission, specs)).object()}};
    if (flown.seed)
        json["seed"] = QString::number(*flown.seed); // A number in JSON would lose digits beyond 2^53.
    if (!flown.continues.isEmpty())
        json["continues"] = flown.continues;
    return QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString();
}

Result<FlownMission> readFlownMission(std::string_view text, const QString& recording) {
    const QJsonObject json =
        QJsonDocument::fromJson(QByteArray(text.data(), static_cast<qsizetype>(text.size()))).object();
    const auto mission = readMission(QJsonDocument(json["mission"].toObject()).toJson(), recording);
    if (!mission)
        return tl::unexpected(mission.error());
    FlownMission flown{*mission, {}, json["continues"].toString()};
    flown.mission.places.clear(); // They are of a text that nobody sees.
    bool is_number = false;
    if (const auto seed = json["seed"].toString().toULongLong(&is_number); is_number)
        flown.seed = seed;
    return flown;
}

} // namespace usar::mission
