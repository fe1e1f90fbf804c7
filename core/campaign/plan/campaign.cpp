#include "core/campaign/plan/campaign.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>

#include "core/campaign/plan/mission_names.h"
#include "core/mission/files/json_reading.h"

namespace usar::campaign {

namespace {

using mission::JsonReading;

constexpr double most_seeds = 10e6;

const JsonReading::KnownKeys known_keys{
    {"", {"name", "missions", "variants", "seeds", "faults", "swarm", "again", "limit_h", "wall_limit_s", "keep"}},
    {"seeds", {"first", "count"}},
    {"swarm", {"share", "from_s", "kinds"}},
    {"missions[]", {"file", "name", "seeds", "worlds", "draw"}},
    {"missions[].seeds", {"first", "count"}},
    {"variants[]", {"name", "behavior", "plan", "set"}}};

QString beside(const QString& file_name, const std::string& path) {
    return QDir::cleanPath(QFileInfo(file_name).absoluteDir().filePath(QString::fromStdString(path)));
}

/// A world's folder as an absolute path, so that a run's command flies it from any folder. It begins at the campaign's
/// folder, or else where the program was started. A name stays a name.
std::string worldFrom(const QString& file_name, const std::string& world) {
    const QString path = QString::fromStdString(world);
    if (!path.contains('/') || QFileInfo(path).isAbsolute())
        return world;
    const QString own = beside(file_name, world);
    return (QDir(own).exists() || !QDir(path).exists() ? own : QDir(path).absolutePath()).toStdString();
}

/// Reads a whole number from `least` up; leaves the target unchanged if the key is absent.
template <class Whole>
void readWhole(JsonReading& reading, const QJsonObject& object, const QString& path, double least, Whole& target) {
    double value = static_cast<double>(target);
    reading.number(object, path, value, false, "whole numbers");
    if (value < least || value > most_seeds || value != std::trunc(value))
        reading.failAt(path, QString("\"%1\" is out of range").arg(path.section('.', -1)),
                       QString("write a whole number from %1 to %2").arg(least).arg(most_seeds, 0, 'f', 0));
    else
        target = static_cast<Whole>(value);
}

/// "seeds": a count, or an object; `path` is that of the object that contains it, with a dot, or empty.
void readSeeds(JsonReading& reading, const QJsonObject& object, const QString& path, CampaignMission& target) {
    const QString key = path + "seeds";
    if (!object["seeds"].isObject())
        return readWhole(reading, object, key, 1.0, target.seeds);
    readWhole(reading, object["seeds"].toObject(), key + ".first", 0.0, target.first_seed);
    readWhole(reading, object["seeds"].toObject(), key + ".count", 1.0, target.seeds);
}

/// A range [least, most], checked.
bool readRange(const QJsonValue& value, double& least, double& most) {
    const QJsonArray pair = value.toArray();
    if (pair.size() != 2 || !pair[0].isDouble() || !pair[1].isDouble())
        return false;
    least = pair[0].toDouble();
    most = pair[1].toDouble();
    return std::isfinite(least) && std::isfinite(most) && least <= most;
}

std::optional<Draw> drawOf(const QString& key, const QJsonValue& value, const QString& file_name) {
    Draw draw{key.toStdString(), 0.0, 0.0, {}};
    if (readRange(value, draw.least, draw.most))
        return draw;
    for (const QJsonValue choice : value.toArray()) {
        if (!choice.isString())
            return std::nullopt;
        const std::string text = choice.toString().toStdString();
        draw.choices.push_back(key == "world" ? worldFrom(file_name, text) : text);
    }
    return draw.choices.empty() ? std::nullopt : std::optional(draw);
}

CampaignMission readOneMission(JsonReading& reading, const QJsonValue& value, const QString& path,
                               const QString& file_name, CampaignMission usual) {
    std::string file;
    if (value.isString()) {
        file = value.toString().toStdString();
    } else if (value.isObject()) {
        const QJsonObject object = value.toObject();
        reading.text(object, path + ".file", file, true);
        reading.text(object, path + ".name", usual.name);
        readSeeds(reading, object, path + '.', usual);
        for (const std::string& world : reading.texts(object, path + ".worlds", "a world", "tall_test"))
            usual.worlds.push_back(worldFrom(file_name, world));
        if (reading.isObject(object, path + ".draw")) {
            const QJsonObject draws = object["draw"].toObject();
            for (auto it = draws.begin(); it != draws.end(); ++it) {
                if (auto draw = drawOf(it.key(), *it, file_name))
                    usual.draws.push_back(*std::move(draw));
                else
                    reading.failAt(path + ".draw." + it.key(), "this is neither a range nor a list of texts",
                                   "write [least, most] or [\"one\", \"another\"]");
            }
        }
    }
    if (file.empty())
        reading.failAt(path, "a mission has no file", "write its path in quotes, or {\"file\": \"…\"}");
    usual.file = beside(file_name, file);
    return usual;
}

void readMissions(JsonReading& reading, const QJsonObject& root, const QString& file_name, Campaign& campaign) {
    const QJsonValue list = root["missions"];
    if (list.isUndefined())
        return reading.failMissing("missions");
    if (!list.isArray() || list.toArray().isEmpty())
        return reading.failAt("missions", "\"missions\" is not a list of missions", "write it in square brackets");
    CampaignMission usual;
    readSeeds(reading, root, {}, usual);
    std::set<std::string> names;
    for (int i = 0; i < list.toArray().size(); ++i) {
        const QString path = QString("missions[%1]").arg(i);
        campaign.missions.push_back(readOneMission(reading, list.toArray()[i], path, file_name, usual));
        const std::string& name = campaign.missions.back().name;
        if (!name.empty() && !names.insert(name).second)
            reading.failAt(path + ".name", "two missions have the same name", "give each its own");
    }
    nameMissions(campaign.missions);
}

QString textOf(const QJsonValue& value) {
    if (value.isString())
        return value.toString();
    const QByteArray json = QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact);
    return QString::fromUtf8(json.mid(1, json.size() - 2));
}

Variant readVariant(JsonReading& reading, const QJsonValue& value, const QString& path, const QString& file_name) {
    Variant variant;
    const QJsonObject object = value.toObject();
    if (!value.isObject())
        reading.failAt(path, "a variant is not an object", "write {\"name\": \"…\", \"behavior\": \"…\"}");
    reading.text(object, path + ".name", variant.name, true);
    reading.text(object, path + ".behavior", variant.behavior);
    reading.text(object, path + ".plan", variant.plan);
    if (!variant.plan.empty())
        variant.plan = beside(file_name, variant.plan).toStdString();
    if (reading.isObject(object, path + ".set")) {
        const QJsonObject values = object["set"].toObject();
        for (auto it = values.begin(); it != values.end(); ++it) {
            const std::string text = textOf(*it).toStdString();
            variant.values.push_back(it.key().toStdString() + '=' +
                                     (it.key() == "world" ? worldFrom(file_name, text) : text));
        }
    }
    return variant;
}

void readVariants(JsonReading& reading, const QJsonObject& root, const QString& file_name, Campaign& campaign) {
    const QJsonValue list = root["variants"];
    if (list.isUndefined())
        return campaign.variants.push_back({"as written", {}, {}, {}});
    if (!list.isArray() || list.toArray().isEmpty())
        return reading.failAt("variants", "\"variants\" is not a list of variants", "write it in square brackets");
    std::set<std::string> names;
    for (int i = 0; i < list.toArray().size(); ++i) {
        const QString path = QString("variants[%1]").arg(i);
        campaign.variants.push_back(readVariant(reading, list.toArray()[i], path, file_name));
        if (!names.insert(campaign.variants.back().name).second)
            reading.failAt(path + ".name", "two variants have the same name", "give each its own");
    }
}

void readSwarm(JsonReading& reading, const QJsonObject& root, Campaign& campaign) {
    if (!reading.isObject(root, "swarm"))
        return;
    const QJsonObject object = root["swarm"].toObject();
    Swarm& swarm = campaign.swarm.emplace();
    reading.number(object, "swarm.share", swarm.share, false, "parts of 1");
    if (!(swarm.share > 0.0 && swarm.share <= 1.0))
        reading.failAt("swarm.share", "the share is no probability above 0", "write a number such as 0.3");
    if (!object["from_s"].isUndefined() &&
        (!readRange(object["from_s"], swarm.least_s, swarm.most_s) || swarm.least_s < 0.0))
        reading.failAt("swarm.from_s", "this is no range of times", "write [least, most] in seconds, such as [0, 300]");
    swarm.kinds = reading.texts(object, "swarm.kinds", "a kind of fault", "wind");
}

/// Reads the runs that once showed a defect; each must be one that this campaign can fly.
Result<void> readAgain(JsonReading& reading, const QJsonObject& root, const QString& file_name, Campaign& campaign) {
    std::string path;
    reading.text(root, "again", path);
    if (path.empty())
        return {};
    const QString file = beside(file_name, path);
    auto known = readKnownFailures(file);
    if (!known)
        return tl::unexpected(known.error());
    for (const KnownFailure& one : *known) {
        const auto flies = [&](const CampaignMission& mission) { return nameOf(mission).toStdString() == one.mission; };
        if (std::ranges::none_of(campaign.missions, flies))
            return failure("a known failure is of a mission that the campaign has not: " + one.mission,
                           file.toStdString(), "Add the mission, or remove the line");
        if (std::ranges::find(campaign.variants, one.variant, &Variant::name) == campaign.variants.end())
            return failure("a known failure is of a variant that the campaign has not: " + one.variant,
                           file.toStdString(), "Add the variant, or remove the line");
    }
    campaign.again_file = file;
    campaign.again = *std::move(known);
    return {};
}

void readLimits(JsonReading& reading, const QJsonObject& root, Campaign& campaign) {
    if (!root["limit_h"].isUndefined())
        reading.number(root, "limit_h", campaign.limit_h.emplace(), false, "hours");
    reading.number(root, "wall_limit_s", campaign.wall_limit_s, false, "seconds");
    if (campaign.limit_h && !(*campaign.limit_h > 0.0))
        reading.failAt("limit_h", "the limit is no time above 0", "write hours of simulated time, such as 2");
    if (!(campaign.wall_limit_s > 0.0))
        reading.failAt("wall_limit_s", "the limit is no time above 0", "write seconds, such as 600");
    std::string keep = "failures";
    reading.text(root, "keep", keep);
    if (keep == "nothing")
        campaign.keep = Keep::Nothing;
    else if (keep == "everything")
        campaign.keep = Keep::Everything;
    else if (keep != "failures")
        reading.failAt("keep", "this is nothing that can be kept", "write \"nothing\", \"failures\" or \"everything\"");
}

} // namespace

QString nameOf(const CampaignMission& mission) {
    return mission.name.empty() ? QFileInfo(mission.file).completeBaseName() : QString::fromStdString(mission.name);
}

Result<Campaign> readCampaign(const QByteArray& json, const QString& file_name) {
    const auto root = mission::readJsonObject(json, file_name, "a campaign");
    if (!root)
        return tl::unexpected(root.error());
    JsonReading reading(json, file_name, "the campaign");
    reading.checkKeys(known_keys);
    Campaign campaign;
    reading.text(*root, "name", campaign.name, true);
    readMissions(reading, *root, file_name, campaign);
    readVariants(reading, *root, file_name, campaign);
    campaign.faults = reading.texts(*root, "faults", "a fault", "wind speed=5");
    readSwarm(reading, *root, campaign);
    readLimits(reading, *root, campaign);
    campaign.places.by_path = reading.places();
    const auto again = readAgain(reading, *root, file_name, campaign);
    if (reading.error())
        return tl::unexpected(*reading.error());
    return again.map([&] { return std::move(campaign); });
}

Result<Campaign> readCampaignFile(const QString& path) {
    return mission::readJsonFile(path, "campaign").and_then([&](const QByteArray& json) {
        return readCampaign(json, path);
    });
}

} // namespace usar::campaign
