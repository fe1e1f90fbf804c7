#include "core/mission/files/json_reading.h"

#include <algorithm>
#include <cmath>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>
#include <QSet>

#include "core/base/spelling.h"
#include "core/mission/files/scan_record.h"

namespace usar::mission {

namespace {

QString nameOf(const QString& path) {
    return path.section('.', -1);
}

/// "missions[]" for "missions[3]".
QString withoutIndices(QString path) {
    static const QRegularExpression index("\\[\\d+\\]");
    return path.replace(index, "[]");
}

} // namespace

Result<QByteArray> readJsonFile(const QString& path, const QString& kind) {
    constexpr qint64 maximum_bytes = 1 << 20;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure("cannot read the " + kind.toStdString() + ": " + file.errorString().toStdString(),
                       path.toStdString(),
                       "check the path; those that come with the program are in resources/" + kind.toStdString() + "s");
    QByteArray json = file.read(maximum_bytes + 1);
    if (json.size() > maximum_bytes)
        return failure("this file is larger than any " + kind.toStdString(), path.toStdString(),
                       "choose a " + kind.toStdString() + " file (JSON)");
    return json;
}

Result<QJsonObject> readJsonObject(const QByteArray& json, const QString& file_name, const QString& kind) {
    QJsonParseError problem;
    const QJsonDocument document = QJsonDocument::fromJson(json, &problem);
    if (problem.error != QJsonParseError::NoError)
        return failure("this is not JSON: " + problem.errorString().toStdString(),
                       (file_name + ':' + lineAndColumn(json, problem.offset)).toStdString(),
                       "look at this place and just before it for a comma, a quote or a brace");
    if (!document.isObject())
        return failure(kind.toStdString() + " is an object in braces", (file_name + ":1:1").toStdString(),
                       "begin with { and end with }");
    return document.object();
}

std::optional<agent::ParameterValue> parameterOf(const QJsonValue& value) {
    if (value.isBool())
        return value.toBool();
    if (value.isString())
        return value.toString().toStdString();
    if (!value.isDouble())
        return std::nullopt;
    const double number = value.toDouble();
    if (number == std::trunc(number) && std::abs(number) < 1e15)
        return static_cast<long long>(number);
    return number;
}

void JsonReading::checkKeys(const KnownKeys& known) {
    QSet<QString> paths;
    for (const JsonKey& key : keys_) {
        if (const auto found = known.find(withoutIndices(key.parent)); found != known.end())
            checkName(key, found->second);
        if (paths.contains(key.path()))
            fail(key.key_offset, QString("\"%1\" is given twice").arg(key.path()), "keep one of the two");
        paths.insert(key.path());
    }
}

void JsonReading::text(const QJsonObject& object, const QString& path, std::string& target, bool required) {
    const QJsonValue value = object[nameOf(path)];
    if (value.isUndefined()) {
        if (required)
            failMissing(path);
    } else if (!value.isString() || value.toString().trimmed().isEmpty()) {
        failAt(path, QString("\"%1\" is not a text").arg(nameOf(path)), "write it in quotes, not empty");
    } else {
        target = value.toString().toStdString();
    }
}

void JsonReading::number(const QJsonObject& object, const QString& path, double& target, bool required,
                         const QString& unit) {
    const QJsonValue value = object[nameOf(path)];
    if (value.isUndefined()) {
        if (required)
            failMissing(path);
    } else if (!value.isDouble() || !std::isfinite(value.toDouble())) {
        failAt(path, QString("\"%1\" is not a number").arg(nameOf(path)),
               "write it without quotes and unit, in " + unit);
    } else {
        target = value.toDouble();
    }
}

void JsonReading::flag(const QJsonObject& object, const QString& path, bool& target) {
    const QJsonValue value = object[nameOf(path)];
    if (value.isBool())
        target = value.toBool();
    else if (!value.isUndefined())
        failAt(path, QString("\"%1\" is neither true nor false").arg(nameOf(path)), "write it without quotes");
}

std::vector<std::string> JsonReading::texts(const QJsonObject& object, const QString& path, const QString& each,
                                            const QString& example) {
    const QJsonValue value = object[nameOf(path)];
    std::vector<std::string> all;
    if (!value.isUndefined() && !value.isArray())
        failAt(path, QString("\"%1\" is not a list").arg(nameOf(path)), "write it in square brackets");
    for (const QJsonValue one : value.toArray()) {
        if (!one.isString()) {
            failAt(path, each + " is not a text", QString("write each in quotes: \"%1\"").arg(example));
            return {};
        }
        all.push_back(one.toString().toStdString());
    }
    return all;
}

bool JsonReading::isObject(const QJsonObject& object, const QString& path) {
    const QJsonValue value = object[nameOf(path)];
    if (!value.isUndefined() && !value.isObject())
        failAt(path, QString("\"%1\" is not an object").arg(nameOf(path)), "write it in braces");
    return value.isObject();
}

void JsonReading::failAt(const QString& path, const QString& what, const QString& mend) {
    const QString list = path.endsWith(']') ? path.section('[', 0, -2) : QString();
    const auto key =
        std::ranges::find_if(keys_, [&](const JsonKey& k) { return k.path() == path || k.path() == list; });
    fail(key == keys_.end() ? 0 : key->value_offset, what, mend);
}

void JsonReading::fail(qsizetype offset, const QString& what, const QString& mend) {
    if (!error_)
        error_ = Error{what.toStdString(), placeOf(offset), mend.toStdString()};
}

void JsonReading::failMissing(const QString& path) {
    const QString parent = path.section('.', 0, -2);
    const QString inside = parent.isEmpty() ? whole_ : QString("\"%1\"").arg(parent);
    const QString what = QString("the key \"%1\" is missing in %2").arg(nameOf(path), inside);
    if (parent.isEmpty())
        fail(std::max(qsizetype(0), json_.indexOf('{')), what, "add it");
    else
        failAt(parent, what, "add it");
}

std::map<std::string, KeyPlace> JsonReading::places() const {
    std::map<std::string, KeyPlace> places;
    LineWalk walk(json_);
    for (const JsonKey& key : keys_) {
        const QString of_key = file_name_ + ':' + walk.at(key.key_offset);
        const QString of_value = file_name_ + ':' + walk.at(key.value_offset);
        places[key.path().toStdString()] = {of_key.toStdString(), of_value.toStdString()};
    }
    return places;
}

std::string JsonReading::placeOf(qsizetype offset) const {
    return (file_name_ + ':' + lineAndColumn(json_, offset)).toStdString();
}

void JsonReading::checkName(const JsonKey& key, const std::vector<std::string>& known) {
    const std::string name = key.name.toStdString();
    if (std::ranges::find(known, name) != known.end())
        return;
    fail(key.key_offset, QString("unknown key \"%1\"").arg(key.name),
         QString("did you mean \"%1\"? Known here: %2")
             .arg(QString::fromStdString(nearestWord(name, known)), textsOf(known).join(", ")));
}

} // namespace usar::mission
