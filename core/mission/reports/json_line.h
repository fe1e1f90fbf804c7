// JSON objects one per line, as `usar-mission` prints them for scripts.
#pragma once

#include <string>

#include <QIODevice>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/base/result.h"

namespace usar::mission {

/// Returns the object without white space, with a line end.
inline QByteArray jsonLine(const QJsonObject& object) {
    return QJsonDocument(object).toJson(QJsonDocument::Compact) + '\n';
}

/// Prints the object; an error says that `output` accepts no more, and names `where`.
inline Result<void> printLine(const QJsonObject& object, QIODevice& output, const std::string& where) {
    const QByteArray json = jsonLine(object);
    if (output.write(json) != json.size())
        return failure("the output cannot be written: " + output.errorString().toStdString(), where,
                       "Make room, or write elsewhere");
    return {};
}

} // namespace usar::mission
