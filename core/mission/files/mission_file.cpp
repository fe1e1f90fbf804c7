#include "core/mission/files/mission_file.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QSet>
#include <QStringList>

#include "core/base/spelling.h"
#include "core/mission/files/json_positions.h"
#include "core/mission/files/scan_record.h"

namespace usar::mission {

namespace {

const std::vector<std::string> mission_keys{"name", "world",      "robot",       "start",   "behavior", "plan",
                                            "area", "parameters", "cell_size_m", "limit_h", "faults",   "isolate"};
const std::vector<std::string> area_keys{"x", "y", "width", "height"};
constexpr double farthest_m = 1e6;

/// Reads the keys of one file. Only the first error is kept; values read after it are meaningless.
class Reading {
public:
    Reading(const QByteArray& json, const QString& file_name)
        : json_(json)
        , file_name_(file_name)
        , keys_(jsonKeys(json)) {}

    void checkKeys() {
        QSet<QString> paths;
        for (const JsonKey& key : keys_) {
            if (key.parent.isEmpty() || key.parent == "area")
                checkName(key, key.parent.isEmpty() ? mission_keys : area_keys);
            if (paths.contains(key.path()))
                fail(key.key_offset, QString("\"%1\" is given twice").arg(key.path()), "keep one of the two");
            paths.insert(key.path());
        }
    }

    void text(const QJsonObject& object, const QString& key, std::string& target, bool required = false) {
        const QJsonValue value = object[key];
        if (value.isUndefined()) {
            if (required)
                failMissing(key, {});
        } else if (!value.isString() || value.toString().trimmed().isEmpty()) {
            failAt(key, QString("\"%1\" is not a text").arg(key), "write it in quotes, not empty");
        } else {
            target = value.toString().toStdString();
        }
    }

    /// `unit` is the word for the unit of the number in the file, such as "meters".
    void number(const QJsonObject& object, const QString& path, double& target, bool required,
                const QString& unit = "meters") {
        const QString key = path.section('.', -1);
        const QJsonValue value = object[key];
        if (value.isUndefined()) {
            if (required)
                failMissing(key, path.section('.', 0, -2));
        } else if (!value.isDouble() || !std::isfinite(value.toDouble())) {
            failAt(path, QString("\"%1\" is not a number").arg(key), "write it without quotes and unit, in " + unit);
        } else {
            target = value.toDouble();
        }
    }

    void flag(const QJsonObject& object, const QString& key, bool& target) {
        const QJsonValue value = object[key];
        if (value.isBool())
            target = value.toBool();
        else if (!value.isUndefined())
            failAt(key, QString("\"%1\" is neither true nor false").arg(key), "write it without quotes");
    }

    /// True if the key has an object as its value. Reports an error if it has another value.
    bool isObject(const QJsonObject& object, const QString& key) {
        if (!object[key].isUndefined() && !object[key].isObject())
            failAt(key, QString("\"%1\" is not an object").arg(key), "write it in braces");
        return object[key].isObject();
    }

    void failAt(const QString& path, const QString& what, const QString& mend) {
        const auto key = std::find_if(keys_.begin(), keys_.end(), [&](const JsonKey& k) { return k.path() == path; });
        fail(key == keys_.end() ? 0 : key->value_offset, what, mend);
    }

    void fail(qsizetype offset, const QString& what, const QString& mend) {
        if (!error_)
            error_ = Error{what.toStdString(), placeOf(offset), mend.toStdString()};
    }

    /// Places of every key and of its value, by path.
    std::map<std::string, KeyPlace> places() const {
        std::map<std::string, KeyPlace> places;
        LineWalk walk(json_);
        for (const JsonKey& key : keys_) {
            const QString of_key = file_name_ + ':' + walk.at(key.key_offset);
            const QString of_value = file_name_ + ':' + walk.at(key.value_offset);
            places[key.path().toStdString()] = {of_key.toStdString(), of_value.toStdString()};
        }
        return places;
    }

    const std::optional<Error>& error() const { return error_; }

private:
    std::string placeOf(qsizetype offset) const {
        return (file_name_ + ':' + lineAndColumn(json_, offset)).toStdString();
    }

    void checkName(const JsonKey& key, const std::vector<std::string>& known) {
        const std::string name = key.name.toStdString();
        if (std::ranges::find(known, name) != known.end())
            return;
        fail(key.key_offset, QString("unknown key \"%1\"").arg(key.name),
             QString("did you mean \"%1\"? Known here: %2")
                 .arg(QString::fromStdString(nearestWord(name, known)), textsOf(known).join(", ")));
    }

    void failMissing(const QString& key, const QString& parent) {
        const QString inside = parent.isEmpty() ? QString("the mission") : QString("\"%1\"").arg(parent);
        const QString what = QString("the key \"%1\" is missing in %2").arg(key, inside);
        if (parent.isEmpty())
            fail(std::max(qsizetype(0), json_.indexOf('{')), what, "add it");
        else
            failAt(parent, what, "add it");
    }

    const QByteArray& json_;
    QString file_name_;
    std::vector<JsonKey> keys_;
    std::optional<Error> error_;
};

void readArea(Reading& reading, const QJsonObject& root, Rectangle& area_in_map) {
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

void readLimit(Reading& reading, const QJsonObject& root, std::optional<double>& limit_h) {
    if (root["limit_h"].isUndefined())
        return;
    reading.number(root, "limit_h", limit_h.emplace(), false, "hours");
    if (!(*limit_h > 0.0))
        reading.failAt("limit_h", "the limit is no time above 0",
                       "write hours of simulated time, such as 20, or leave it out: then there is no limit");
}

void readParameters(Reading& reading, const QJsonObject& root, Mission& mission) {
    if (!reading.isObject(root, "parameters"))
        return;
    const QJsonObject object = root["parameters"].toObject();
    for (auto it = object.begin(); it != object.end(); ++it) {
        const std::string id = it.key().toStdString();
        const double number = it->toDouble();
        if (it->isBool())
            mission.parameters[id] = it->toBool();
        else if (it->isString())
            mission.parameters[id] = it->toString().toStdString();
        else if (!it->isDouble())
            reading.failAt("parameters." + it.key(), QString("the value of \"%1\" is no parameter").arg(it.key()),
                           "write a number, a text, true or false");
        else if (number == std::trunc(number) && std::abs(number) < 1e15)
            mission.parameters[id] = static_cast<long long>(number);
        else
            mission.parameters[id] = number;
    }
}

void readFaults(Reading& reading, const QJsonObject& root, std::vector<std::string>& faults) {
    const QJsonValue value = root["faults"];
    if (!value.isUndefined() && !value.isArray())
        reading.failAt("faults", "\"faults\" is not a list", "write it in square brackets");
    for (const QJsonValue fault : value.toArray()) {
        if (!fault.isString())
            return reading.failAt("faults", "a fault is not a text", "write each in quotes: \"wind speed=5\"");
        faults.push_back(fault.toString().toStdString());
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
    QJsonParseError problem;
    const QJsonDocument document = QJsonDocument::fromJson(json, &problem);
    if (problem.error != QJsonParseError::NoError)
        return failure("this is not JSON: " + problem.errorString().toStdString(),
                       (file_name + ':' + lineAndColumn(json, problem.offset)).toStdString(),
                       "look at this place and just before it for a comma, a quote or a brace");
    if (!document.isObject())
        return failure("a mission is an object in braces", (file_name + ":1:1").toStdString(),
                       "begin with { and end with }");

    Reading reading(json, file_name);
    reading.checkKeys();
    const QJsonObject root = document.object();
    Mission mission;
    reading.text(root, "name", mission.name, true);
    reading.text(root, "world", mission.world);
    reading.text(root, "robot", mission.robot_class);
    reading.text(root, "start", mission.start);
    reading.text(root, "behavior", mission.behavior);
    reading.text(root, "plan", mission.plan);
    readArea(reading, root, mission.area_in_map);
    readParameters(reading, root, mission);
    reading.number(root, "cell_size_m", mission.cell_size_m, false);
    readLimit(reading, root, mission.limit_h);
    readFaults(reading, root, mission.faults);
    reading.flag(root, "isolate", mission.isolate);
    if (!(mission.cell_size_m >= 0.02 && mission.cell_size_m <= 10.0))
        reading.failAt("cell_size_m", "the cell size is out of range", "choose 0.02 to 10 m; 0.25 m is the usual one");
    if (reading.error())
        return tl::unexpected(*reading.error());
    mission.places = reading.places();
    if (!mission.plan.empty())
        mission.plan = beside(file_name, QString::fromStdString(mission.plan)).toStdString();
    return mission;
}

Result<Mission> readMissionFile(const QString& path) {
    constexpr qint64 maximum_bytes = 1 << 20;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure("cannot read the mission: " + file.errorString().toStdString(), path.toStdString(),
                       "check the path; missions that come with the program are in resources/missions");
    const QByteArray json = file.read(maximum_bytes + 1);
    if (json.size() > maximum_bytes)
        return failure("this file is larger than any mission", path.toStdString(), "choose a mission file (JSON)");
    return readMission(json, path);
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
    if (!mission.plan.empty())
        all["plan"] = planPath(QString::fromStdString(mission.plan), folder);
    if (const Rectangle& area = mission.area_in_map; !area.empty())
        all["area"] = QJsonObject{
            {"x", area.min_m.x()}, {"y", area.min_m.y()}, {"width", area.width_m()}, {"height", area.height_m()}};
    if (mission.limit_h)
        all["limit_h"] = *mission.limit_h;
    if (mission.isolate)
        all["isolate"] = true;
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
