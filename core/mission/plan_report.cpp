#include "core/mission/plan_report.h"

#include <algorithm>
#include <string_view>

#include <QJsonDocument>

#include "core/posh/plan_reader.h"
#include "core/posh/token.h"

namespace usar::mission {

namespace {

/// Not more than shows that it is too long: a device may never end.
QByteArray readPlanText(QIODevice& input) {
    constexpr qsizetype most = static_cast<qsizetype>(posh::longest_plan_bytes) + 1;
    QByteArray text;
    while (text.size() < most) {
        const QByteArray piece = input.read(std::min<qsizetype>(most - text.size(), 1 << 20));
        if (piece.isEmpty())
            break;
        text += piece;
    }
    return text;
}

} // namespace

QJsonObject toJson(const posh::Finding& finding, const QString& file) {
    const bool is_error = posh::severityOf(finding.code) == Severity::Error;
    QJsonObject object{
        {"code", QString::fromStdString(toText(finding.code))}, {"severity", is_error ? "error" : "warning"},
        {"line", static_cast<qint64>(finding.at.line)},         {"column", static_cast<qint64>(finding.at.column)},
        {"message", QString::fromStdString(finding.message)},   {"file", file}};
    if (finding.opener)
        object["opener"] = QJsonObject{{"line", static_cast<qint64>(finding.opener->line)},
                                       {"column", static_cast<qint64>(finding.opener->column)}};
    return object;
}

Result<void> reportFindings(const posh::Findings& findings, const QString& file, QIODevice& output) {
    for (const posh::Finding& finding : findings) {
        const QByteArray json = QJsonDocument(toJson(finding, file)).toJson(QJsonDocument::Compact) + '\n';
        if (output.write(json) != json.size())
            return failure("the output takes no more: " + output.errorString().toStdString(), file.toStdString(),
                           "Make room, or write elsewhere");
    }
    return {};
}

Result<bool> reportPlan(QIODevice& input, const QString& file, QIODevice& output) {
    const QByteArray bytes = readPlanText(input);
    const posh::PlanReading reading =
        posh::readPlan(std::string_view(bytes.data(), static_cast<std::size_t>(bytes.size())));
    if (auto reported = reportFindings(reading.findings, file, output); !reported)
        return tl::unexpected(reported.error());
    return !posh::hasErrors(reading.findings);
}

} // namespace usar::mission
