#include "core/campaign/plan/known_failures.h"

#include <algorithm>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "core/mission/files/scan_record.h"
#include "core/mission/reports/json_line.h"

namespace usar::campaign {

namespace {

std::vector<std::string> textsIn(const QJsonValue& list) {
    std::vector<std::string> texts;
    for (const QJsonValue text : list.toArray())
        texts.push_back(text.toString().toStdString());
    return texts;
}

QByteArray lineOf(const KnownFailure& failure) {
    return mission::jsonLine({{"mission", QString::fromStdString(failure.mission)},
                              {"variant", QString::fromStdString(failure.variant)},
                              {"seed", static_cast<qint64>(failure.seed)},
                              {"faults", QJsonArray::fromStringList(mission::textsOf(failure.faults))},
                              {"values", QJsonArray::fromStringList(mission::textsOf(failure.values))},
                              {"broke", QString::fromStdString(failure.broke)}});
}

} // namespace

Result<std::vector<KnownFailure>> readKnownFailures(const QString& path) {
    std::vector<KnownFailure> failures;
    QFile file(path);
    if (!file.exists())
        return failures;
    if (!file.open(QIODevice::ReadOnly))
        return failure("the known failures cannot be read: " + file.errorString().toStdString(), path.toStdString(),
                       "Check the permissions");
    int number = 0;
    while (!file.atEnd()) {
        const QByteArray line = file.readLine();
        ++number;
        if (line.trimmed().isEmpty())
            continue;
        const QJsonObject read = QJsonDocument::fromJson(line).object();
        if (!read["mission"].isString() || !read["variant"].isString() || !read["seed"].isDouble())
            return failure("this line is no known failure", path.toStdString() + ':' + std::to_string(number),
                           "Remove it, or mend it after the pattern of the others");
        failures.push_back({read["mission"].toString().toStdString(), read["variant"].toString().toStdString(),
                            static_cast<std::uint64_t>(read["seed"].toInteger()), textsIn(read["faults"]),
                            textsIn(read["values"]), read["broke"].toString().toStdString()});
    }
    return failures;
}

Result<void> addKnownFailures(const QString& path, const std::vector<KnownFailure>& failures) {
    const auto known = readKnownFailures(path);
    if (!known)
        return tl::unexpected(known.error());
    QByteArray lines;
    for (const KnownFailure& one : failures)
        if (std::ranges::find(*known, one) == known->end())
            lines += lineOf(one);
    QFile file(path);
    if (lines.isEmpty() || (file.open(QIODevice::Append) && file.write(lines) == lines.size() && file.flush()))
        return {};
    return failure("the known failures cannot be written: " + file.errorString().toStdString(), path.toStdString(),
                   "Give another file with --shrink");
}

} // namespace usar::campaign
