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

/// True for a file whose last line somebody has left without an end.
bool lacksLineEnd(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) && file.size() > 0 && file.seek(file.size() - 1) && file.read(1) != "\n";
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
    QFile file(path);
    QByteArray lines = lacksLineEnd(path) ? "\n" : "";
    for (auto one = failures.begin(); one != failures.end(); ++one)
        if (std::ranges::find(*known, *one) == known->end() && std::find(failures.begin(), one, *one) == one)
            lines += lineOf(*one);
    if (file.open(QIODevice::Append) && file.write(lines) == lines.size() && file.flush())
        return {};
    return failure("the known failures cannot be written: " + file.errorString().toStdString(), path.toStdString(),
                   "Give another file with --shrink");
}

} // namespace usar::campaign
