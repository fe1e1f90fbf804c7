#include "core/mission/files/mission_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QStringList>

#include "core/mission/files/json_reading.h"
#include "core/mission/files/scan_record.h"

namespace usar::mission {

namespace {

const std::vector<std::string> mission_keys{"name", "world",      "robot",       "start",   "behavior", "plan",
                                            "area", "parameters", "cell_size_m", "limit_h", "faults",   "isolate",
                                            "seed", "claims",     "adjust",      "preset"};
const std::vector<std::string> area_keys{"x", "y", "width", "height"};
constexpr double farthest_m = 1e6;
constexpr std::uint64_t largest_exact = std::uint64_t{1} << 53; ///< Whole numbers in JSON are exact below it.

void readArea(JsonReading& reading, const QJsonObject& root, Rectangle& area_in_map) {
    if (!reading.isObject(root, "area"))
        return;
    const QJsonObject object = root["area"].toObject();
    Vec2 size_m = Vec2::Zero();
    reading.number(object, "area.x", area_in_map.min_m.x(), true);
    reading.number(object, "area.y", area_in_map.min_m.y(), true);
    reading.number(object, "area.width", size_m.x(), true);
    reading.number(object, "area.height", size_m.y(), true);
    area_in_map.max_m = area_in_map.min_m + size_m;
    for (const QString& key : {QString("width"), QString("height")}) {
        if (!(object[key].toDouble() > 0.0))
            reading.failAt("area." + key, "the area has no size", QString("make \"%1\" larger than zero").arg(key));
    }
    if (area_in_map.min_m.cwiseAbs().maxCoeff() > farthest_m || area_in_map.max_m.cwiseAbs().maxCoeff() > farthest_m)
        reading.failAt("area", "the area is larger or further away than any world",
                       "stay within a thousand kilometers of the origin");
}

void readLimit(JsonReading& reading, const QJsonObject& root, std::optional<double>& limit_h) {
    if (root["limit_h"].isUndefined())
        return;
    reading.number(root, "limit_h", limit_h.emplace(), false, "hours");
    if (!(*limit_h > 0.0))
        reading.failAt("limit_h", "the limit is no time above 0",
                       "write hours of simulated time, such as 20, or leave it out: then there is no limit");
    else if (!(*limit_h >= shortest_limit_h && *limit_h <= longest_limit_h))
        reading.failAt("limit_h", "the limit is not between 0.000001 and 10000 hours",
                       "write hours of simulated time, such as 20, or leave it out: then there is no limit");
}

/// Larger seeds than a number in JSON can hold exactly are written as texts.
void readSeed(JsonReading& reading, const QJsonObject& root, std::optional<std::uint64_t>& seed) {
    const QJsonValue value = root["seed"];
    if (value.isUndefined())
        return;
    const double number = value.toDouble(-1.0);
    bool is_whole = value.isString();
    if (is_whole)
        seed = value.toString().toULongLong(&is_whole);
    else if (is_whole = number >= 0.0 && number < static_cast<double>(largest_exact) && number == std::trunc(number);
             is_whole)
        seed = static_cast<std::uint64_t>(number);
    if (!is_whole || *seed > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
        reading.failAt("seed", "the seed is no whole number from 0 up to 9223372036854775807",
                       "write for example 7, and one above 9007199254740991 in quotes");
}

void readParameters(JsonReading& reading, const QJsonObject& root, Mission& mission) {
    if (!reading.isObject(root, "parameters"))
        return;
    const QJsonObject object = root["parameters"].toObject();
    for (auto it = object.begin(); it != object.end(); ++it) {
        if (const auto value = parameterOf(*it))
            mission.parameters[it.key().toStdString()] = *value;
        else
            reading.failAt("parameters." + it.key(), QString("the value of \"%1\" is no parameter").arg(it.key()),
                           "write a number, a text, true or false");
    }
}

QString beside(const QString& file_name, const QString& path) {
    return QDir::cleanPath(QFileInfo(file_name).dir().filePath(path));
}

/// Puts the place into the error; its former `where` goes into the sentence instead.
Error at(const std::string& place, const Error& error) {
    return {error.where.empty() ? error.what : error.where + ": " + error.what, place, error.mend};
}

QJsonValue written(const agent::ParameterValue& value, bool is_angle) {
    if (const auto* real = std::get_if<double>(&value))
        return is_angle ? typedDegrees(*real) : *real;
    if (const auto* whole = std::get_if<long long>(&value))
        return static_cast<qint64>(*whole);
    if (const auto* flag = std::get_if<bool>(&value))
        return *flag;
    return QString::fromStdString(std::get<std::string>(value));
}

/// Returns the path relative to the folder if the plan is inside it, so that both can be moved together; else absolute.
QString planPath(const QString& plan, const QString& folder) {
    const QString absolute = QFileInfo(plan).absoluteFilePath();
    const QString relative = folder.isEmpty() ? absolute : QDir(folder).relativeFilePath(absolute);
    return relative.startsWith("..") ? absolute : relative;
}

} // namespace

Result<Mission> readMission(const QByteArray& json, const QString& file_name) {
    const auto object = readJsonObject(json, file_name, "a mission");
    if (!object)
        return tl::unexpected(object.error());
    const QJsonObject& root = *object;
    JsonReading reading(json, file_name, "the mission");
    reading.checkKeys({{"", mission_keys}, {"area", area_keys}, {"claims[]", claimKeys()}});
    Mission mission;
    reading.text(root, "name", mission.name, true);
    reading.text(root, "world", mission.world);
    reading.text(root, "robot", mission.robot_class);
    reading.text(root, "start", mission.start);
    reading.text(root, "behavior", mission.behavior);
    reading.text(root, "plan", mission.plan);
    readArea(reading, root, mission.area_in_map);
    reading.text(root, "preset", mission.preset);
    readParameters(reading, root, mission);
    reading.number(root, "cell_size_m", mission.cell_size_m, false);
    readLimit(reading, root, mission.limit_h);
    mission.faults = reading.texts(root, "faults", "a fault", "wind speed=5");
    reading.flag(root, "isolate", mission.isolate);
    reading.flag(root, "adjust", mission.adjust);
    readSeed(reading, root, mission.seed);
    mission.claims = readClaims(reading, root);
    if (!(mission.cell_size_m >= smallest_cell_m && mission.cell_size_m <= largest_cell_m))
        reading.failAt("cell_size_m", "the cell size is out of range", "choose 0.02 to 10 m; 0.25 m is the usual one");
    if (reading.error())
        return tl::unexpected(*reading.error());
    mission.places = reading.places();
    if (!mission.plan.empty())
        mission.plan = beside(file_name, QString::fromStdString(mission.plan)).toStdString();
    return mission;
}

Result<Mission> readMissionFile(const QString& path) {
    return readJsonFile(path, "mission").and_then([&](const QByteArray& json) { return readMission(json, path); });
}

Error atKey(const Mission& mission, const std::string& path, const Error& error) {
    const auto found = mission.places.find(path);
    return found == mission.places.end() ? error : at(found->second.key, error);
}

Error atValue(const Mission& mission, const std::string& path, const Error& error) {
    const auto found = mission.places.find(path);
    return found == mission.places.end() ? error : at(found->second.value, error);
}

std::map<std::string, agent::ParameterValue>
withAnglesInRadians(std::map<std::string, agent::ParameterValue> parameters,
                    const std::vector<agent::ParameterSpec>& specs) {
    for (const agent::ParameterSpec& spec : specs) {
        const auto found = parameters.find(spec.id);
        if (spec.unit != "rad" || found == parameters.end())
            continue;
        if (const auto* whole = std::get_if<long long>(&found->second))
            found->second = radians(static_cast<double>(*whole));
        else if (const auto* real = std::get_if<double>(&found->second))
            found->second = radians(*real);
    }
    return parameters;
}

Seconds limitFrom(const std::optional<double>& limit_h) {
    return Seconds{limit_h.value_or(std::numeric_limits<double>::infinity()) * 3600.0};
}

double typedDegrees(double angle_rad) {
    constexpr double grain = 1e9;
    return std::round(degrees(angle_rad) * grain) / grain;
}

QByteArray writeMission(const Mission& mission, const std::vector<agent::ParameterSpec>& specs, const QString& folder) {
    QJsonObject parameters;
    for (const auto& [id, value] : mission.parameters) {
        const bool is_angle = std::ranges::any_of(
            specs, [&id = id](const agent::ParameterSpec& spec) { return spec.id == id && spec.unit == "rad"; });
        parameters[QString::fromStdString(id)] = written(value, is_angle);
    }
    QJsonObject all{{"name", QString::fromStdString(mission.name)},
                    {"world", QString::fromStdString(mission.world)},
                    {"robot", QString::fromStdString(mission.robot_class)},
                    {"start", QString::fromStdString(mission.start)},
                    {"behavior", QString::fromStdString(mission.behavior)},
                    {"parameters", parameters},
                    {"cell_size_m", mission.cell_size_m}};
    if (!mission.preset.empty())
        all["preset"] = QString::fromStdString(mission.preset);
    if (!mission.plan.empty())
        all["plan"] = planPath(QString::fromStdString(mission.plan), folder);
    if (const Rectangle& area = mission.area_in_map; !area.empty())
        all["area"] = QJsonObject{
            {"x", area.min_m.x()}, {"y", area.min_m.y()}, {"width", area.width_m()}, {"height", area.height_m()}};
    if (mission.limit_h)
        all["limit_h"] = *mission.limit_h;
    if (mission.isolate)
        all["isolate"] = true;
    if (mission.adjust)
        all["adjust"] = true;
    if (mission.seed)
        all["seed"] = *mission.seed < largest_exact ? QJsonValue(static_cast<qint64>(*mission.seed))
                                                    : QJsonValue(QString::number(*mission.seed));
    if (!mission.claims.empty())
        all["claims"] = claimsToJson(mission.claims);
    if (!mission.faults.empty())
        all["faults"] = QJsonArray::fromStringList(textsOf(mission.faults));
    return QJsonDocument(all).toJson(QJsonDocument::Indented);
}

Result<void> writeMissionFile(const Mission& mission, const std::vector<agent::ParameterSpec>& specs,
                              const QString& path) {
    QSaveFile file(path);
    const QByteArray json = writeMission(mission, specs, QFileInfo(path).absolutePath());
    if (file.open(QIODevice::WriteOnly) && file.write(json) == json.size() && file.commit())
        return {};
    return failure("the mission is not saved: " + file.errorString().toStdString(), path.toStdString(),
                   "Choose a folder that you may write to, with room on its disk");
}

} // namespace usar::mission
