// Reading of JSON files that people write, with errors that name file, line and column.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QByteArray>
#include <QJsonObject>
#include <QString>

#include "core/base/result.h"
#include "core/mission/files/json_positions.h"
#include "core/mission/files/mission_file.h"

namespace usar::mission {

/// Reads a file of at most 1 MiB. `kind` is the word for it in errors: "mission".
Result<QByteArray> readJsonFile(const QString& path, const QString& kind);
/// Parses the text, which must be one object. `kind` is the word for it in errors, with its article: "a mission".
Result<QJsonObject> readJsonObject(const QByteArray& json, const QString& file_name, const QString& kind);

/// A value of a parameter: a number, which is whole if it is written so, a text, true or false; otherwise nullopt.
std::optional<agent::ParameterValue> parameterOf(const QJsonValue& value);

/// Reads the keys of one file. Only the first error is kept; values read after it are meaningless. Paths of keys are
/// those of JsonKey. Belongs to the function that reads.
class JsonReading {
public:
    /// `json` must have been parsed before and outlive this object. `whole` is the word for the outermost object: "the
    /// mission".
    JsonReading(const QByteArray& json, const QString& file_name, const QString& whole)
        : json_(json)
        , file_name_(file_name)
        , whole_(whole)
        , keys_(jsonKeys(json)) {}

    /// Names of known keys, by the path of the object that has them; "" is the outermost. The keys of an object within
    /// a list are found under the list's name with "[]".
    using KnownKeys = std::map<QString, std::vector<std::string>>;
    /// Fails at a key that is given twice, and at an unknown one in the objects that `known` names.
    void checkKeys(const KnownKeys& known);

    /// The functions below leave `target` unchanged if the key is absent; they fail if it is required, or if its value
    /// is of another kind. The path's last part is the name of the key in `object`.
    void text(const QJsonObject& object, const QString& path, std::string& target, bool required = false);
    /// `unit` is the word for the unit of the number in the file, such as "meters".
    void number(const QJsonObject& object, const QString& path, double& target, bool required,
                const QString& unit = "meters");
    void flag(const QJsonObject& object, const QString& path, bool& target);
    /// Returns a list of texts; empty if the key is absent. `each` and `example` are for the error: "a fault", "wind
    /// speed=5".
    std::vector<std::string> texts(const QJsonObject& object, const QString& path, const QString& each,
                                   const QString& example);
    /// True if the key has an object as its value. Fails if it has another value.
    bool isObject(const QJsonObject& object, const QString& path);

    /// Keeps an error at the value of the key with this path, for an element of a list at the list, or at the file's
    /// beginning if there is no such key.
    void failAt(const QString& path, const QString& what, const QString& mend);
    void fail(qsizetype offset, const QString& what, const QString& mend);
    void failMissing(const QString& path);

    /// Places of every key and of its value, by path.
    std::map<std::string, KeyPlace> places() const;
    const std::optional<Error>& error() const { return error_; }

private:
    std::string placeOf(qsizetype offset) const;
    void checkName(const JsonKey& key, const std::vector<std::string>& known);

    const QByteArray& json_;
    QString file_name_;
    QString whole_;
    std::vector<JsonKey> keys_;
    std::optional<Error> error_;
};

} // namespace usar::mission
