#include "core/mission/reports/plan_report.h"

#include "core/agent/posh/posh_binding.h"
#include "core/mission/files/plan_file.h"
#include "core/mission/reports/json_line.h"
#include "core/posh/language/plan_reader.h"

namespace usar::mission {

namespace {

QJsonObject problemAt(const posh::Spot& at, const QString& code, const char* severity, const std::string& message,
                      const QString& file) {
    return {{"code", code},
            {"severity", severity},
            {"line", static_cast<qint64>(at.line)},
            {"column", static_cast<qint64>(at.column)},
            {"message", QString::fromStdString(message)},
            {"file", file}};
}

QJsonObject toJson(const posh::Finding& finding, const QString& file) {
    const bool is_error = posh::severityOf(finding.code) == Severity::Error;
    QJsonObject object = problemAt(finding.at, QString::fromStdString(toText(finding.code)),
                                   is_error ? "error" : "warning", finding.message, file);
    if (finding.opener)
        object["opener"] = QJsonObject{{"line", static_cast<qint64>(finding.opener->line)},
                                       {"column", static_cast<qint64>(finding.opener->column)}};
    return object;
}

Result<void> print(const QJsonObject& object, QIODevice& output) {
    return printLine(object, output, object["file"].toString().toStdString());
}

} // namespace

Result<bool> reportPlan(QIODevice& input, const QString& file, QIODevice& output,
                        const std::vector<agent::PrimitiveDescription>* primitives) {
    const std::string text = readPlanText(input);
    const posh::PlanReading reading = posh::readPlan(text);
    const posh::Findings findings = primitives ? agent::bindPlan(text, *primitives).findings : reading.findings;
    for (const posh::Finding& finding : findings)
        if (auto printed = print(toJson(finding, file), output); !printed)
            return tl::unexpected(printed.error());
    if (const std::string note = agent::clockRemark(reading.plan); !note.empty())
        if (auto printed = print(problemAt(posh::collectionOf(reading.plan)->at, "N501", "note", note, file), output);
            !printed)
            return tl::unexpected(printed.error());
    return !posh::hasErrors(findings);
}

} // namespace usar::mission
