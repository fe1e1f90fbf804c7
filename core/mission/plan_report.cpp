#include "core/mission/plan_report.h"

#include <QJsonDocument>

#include "core/agent/posh_binding.h"
#include "core/mission/plan_file.h"
#include "core/posh/plan_reader.h"

namespace usar::mission {

namespace {

posh::Findings findingsIn(const std::string& text, const std::vector<agent::PrimitiveDescription>* primitives) {
    return primitives ? agent::bindPlan(text, *primitives).findings : posh::readPlan(text).findings;
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

Result<bool> reportPlan(QIODevice& input, const QString& file, QIODevice& output,
                        const std::vector<agent::PrimitiveDescription>* primitives) {
    const posh::Findings findings = findingsIn(readPlanText(input), primitives);
    if (auto reported = reportFindings(findings, file, output); !reported)
        return tl::unexpected(reported.error());
    return !posh::hasErrors(findings);
}

} // namespace usar::mission
