#include "core/campaign/runs/run_result.h"

#include <array>
#include <utility>

#include <QJsonArray>
#include <QJsonDocument>
#include <QSet>

#include "core/mission/reports/json_line.h"

namespace usar::campaign {

using namespace Qt::StringLiterals;

namespace {

constexpr std::array<std::pair<Outcome, const char*>, 7> words{{{Outcome::Done, "done"},
                                                                {Outcome::Failed, "failed"},
                                                                {Outcome::Refused, "refused"},
                                                                {Outcome::Crashed, "crashed"},
                                                                {Outcome::Killed, "killed"},
                                                                {Outcome::TimedOut, "timed-out"},
                                                                {Outcome::OutOfMemory, "out-of-memory"}}};

const QByteArray before_summary = ",\"summary\":";

QJsonObject objectIn(const QByteArray& line, ResultPart part, QJsonParseError& problem) {
    // In a text within quotes, the quotes of this would be escaped, so it can only begin the summary.
    const qsizetype head = part == ResultPart::Head ? line.indexOf(before_summary) : -1;
    const bool has_end = QByteArrayView(line).trimmed().endsWith("}}"); // A line that lost it is told as the whole is.
    if (head >= 0 && has_end) {
        const QJsonObject read = QJsonDocument::fromJson(line.left(head) + '}', &problem).object();
        if (read.contains("version"_L1)) // Once, the summary stood in the middle of its line.
            return read;
    }
    return QJsonDocument::fromJson(line, &problem).object();
}

} // namespace

QString wordOf(Outcome outcome) {
    return QString(words.at(static_cast<std::size_t>(outcome)).second);
}

std::optional<Outcome> outcomeFrom(const QString& word) {
    for (const auto& [outcome, name] : words)
        if (word == QLatin1String(name))
            return outcome;
    return std::nullopt;
}

QByteArray toLine(const RunResult& result) {
    QJsonObject line{{"run", result.number},
                     {"pair", result.pair},
                     {"mission", QString::fromStdString(result.mission)},
                     {"variant", QString::fromStdString(result.variant)},
                     {"seed", static_cast<qint64>(result.seed)},
                     {"outcome", wordOf(result.outcome)},
                     {"reason", QString::fromStdString(result.reason)},
                     {"wall_s", result.wall_s},
                     {"version", QString::fromStdString(result.version)},
                     {"command", result.command}};
    if (result.limit_s)
        line["limit_s"] = *result.limit_s;
    if (result.differences)
        line["differences"] = QJsonArray::fromStringList(*result.differences);
    if (!result.broken.isEmpty())
        line["broken"] = QJsonArray::fromStringList(result.broken);
    QByteArray text = mission::jsonLine(line);
    if (!result.summary.isEmpty())
        text.replace(text.lastIndexOf('}'), 1,
                     before_summary + QJsonDocument(result.summary).toJson(QJsonDocument::Compact) + '}');
    return text;
}

Result<RunResult> readResultLine(const QByteArray& line, ResultPart part) {
    QJsonParseError problem;
    const QJsonObject read = objectIn(line, part, problem);
    if (problem.error != QJsonParseError::NoError)
        return failure("this is not JSON: " + problem.errorString().toStdString(), {});
    const auto outcome = outcomeFrom(read["outcome"_L1].toString());
    const int number = read["run"_L1].toInt(-1);
    const int pair = read["pair"_L1].toInt(-1);
    if (!outcome || number < 0 || pair < 0)
        return failure("this is no result of a run", {});
    RunResult result{number,
                     pair,
                     read["mission"_L1].toString().toStdString(),
                     read["variant"_L1].toString().toStdString(),
                     static_cast<std::uint64_t>(read["seed"_L1].toInteger()),
                     *outcome,
                     read["reason"_L1].toString().toStdString(),
                     read["wall_s"_L1].toDouble(),
                     read["version"_L1].toString().toStdString(),
                     read["command"_L1].toString(),
                     read["limit_s"_L1].isDouble() ? std::optional(read["limit_s"_L1].toDouble()) : std::nullopt,
                     read["summary"_L1].toObject()};
    for (const QJsonValue sentence : read["broken"_L1].toArray())
        result.broken << sentence.toString();
    if (read.contains("differences"_L1))
        for (const QJsonValue name : result.differences.emplace(), read["differences"_L1].toArray())
            *result.differences << name.toString();
    return result;
}

QStringList differencesOf(const QJsonObject& summary, const QJsonObject& again) {
    QSet<QString> may_differ{"wall_s", "speed_x", "cpu_s", "files", "unwritten"};
    if (!summary.contains("course") || !again.contains("course"))
        may_differ << "course"; // Only a campaign asks for it.
    QSet<QString> keys;
    for (const QJsonObject& one : {summary, again})
        for (const QString& key : one.keys())
            keys << key;
    QStringList differ;
    for (const QString& key : keys - may_differ)
        if (summary[key] != again[key])
            differ << key;
    differ.sort();
    return differ;
}

} // namespace usar::campaign
