#include "core/mission/reports/plan_report.h"

#include "core/agent/posh/posh_binding.h"
#include "core/mission/files/plan_file.h"
#include "core/mission/reports/json_line.h"
#include "core/posh/language/plan_reader.h"

namespace usar::mission {

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

namespace {

QJsonObject noteToJson(const posh::Spot& at, const std::string& message, const QString& file) {
    return {{"code", "N501"},
            {"severity", "note"},
            {"line", static_cast<qint64>(at.line)},
            {"column", static_cast<qint64>(at.column)},
            {"message", QString::fromStdString(message)},
            {"file", file}};
}

Result<void> print(const QJsonObject& object, QIODevice& output) {
    return printLine(object, output, object["file"].toString().toStdString());
}

} // namespace

Result<void> reportFindings(const posh::Findings& findings, const QString& file, QIODevice& output) {
    for (const posh::Finding& finding : findings)
        if (auto printed = print(toJson(finding, file), output); !printed)
            return printed;
    return {};
}

Result<bool> reportPlan(QIODevice& input, const QString& file, QIODevice& output,
                        const std::vector<agent::PrimitiveDescription>* primitives) {
    const std::string text = readPlanText(input);
    const posh::PlanReading reading = posh::readPlan(text);
    const posh::Findings findings = primitives ? agent::bindPlan(text, *primitives).findings : reading.findings;
    if (auto reported = reportFindings(findings, file, output); !reported)
        return tl::unexpected(reported.error());
    if (const std::string note = agent::clockRemark(reading.plan); !note.empty())
        if (auto printed = print(noteToJson(posh::collectionOf(reading.plan)->at, note, file), output); !printed)
            return tl::unexpected(printed.error());
    return !posh::hasErrors(findings);
}

} // namespace usar::mission
