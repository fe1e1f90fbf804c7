#include "core/mission/reports/run_report_text.h"

#include <array>

#include <QJsonObject>
#include <QSaveFile>

#include "core/base/numbers.h"
#include "core/mission/reports/json_line.h"
#include "core/posh/trace/run_report.h"

namespace usar::mission {

namespace {

using posh::Index;
using posh::PlaceCounts;

double seconds(std::int64_t time_ms) {
    return static_cast<double>(time_ms) / 1000.0;
}

double milliseconds(std::uint64_t time_ns) {
    return static_cast<double>(time_ns) / 1e6;
}

/// Share of the whole plan's time, in percent.
double share_pct(const posh::RunStatistics& statistics, Index place) {
    const std::int64_t whole_ms = statistics.at(0).active_ms;
    return whole_ms > 0 ? 100.0 * static_cast<double>(statistics.at(place).active_ms) / static_cast<double>(whole_ms)
                        : 0.0;
}

const char* typeOf(posh::PlaceKind kind) {
    constexpr std::array<const char*, 9> words{"collection", "drive", "competence", "pattern", "adopt",
                                               "element",    "act",   "sense",      "sense"};
    return words[static_cast<std::size_t>(kind)];
}

bool isSense(posh::PlaceKind kind) {
    return kind == posh::PlaceKind::Sense || kind == posh::PlaceKind::SenseStep;
}

std::string padded(std::string text, std::size_t width) {
    return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

std::string counted(std::uint64_t count, const char* one, const char* many) {
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

/// Formats a line such as "  67.7 %   812.4 s   4062 starts   P2DX ▸ ahead".
std::string lineOf(const posh::RunStatistics& statistics, Index place) {
    const PlaceCounts& counts = statistics.at(place);
    std::string line = padded(fixed(share_pct(statistics, place), 1), 7) + " %" +
                       padded(fixed(seconds(counts.active_ms), 1), 11) + " s" +
                       padded(std::to_string(counts.started), 9) + " starts   " +
                       posh::namePathOf(*statistics.program(), place);
    if (counts.spent_ns > 0)
        line += " (" + fixed(milliseconds(counts.spent_ns), 3) + " ms in its code, at most " +
                fixed(milliseconds(counts.longest_ns), 3) + " ms a cycle)";
    return line + '\n';
}

QJsonObject placeObject(const posh::Program& program, Index place, const char* kind) {
    const posh::Place& here = program.places[place];
    return {{"kind", kind},
            {"plan", QString::fromStdString(program.title)},
            {"path", QString::fromStdString(posh::pathOf(program, place))},
            {"name", QString::fromStdString(posh::namePathOf(program, place))},
            {"line", static_cast<qint64>(here.at.line)},
            {"column", static_cast<qint64>(here.at.column)}};
}

QJsonObject elementObject(const posh::RunStatistics& statistics, Index place) {
    const posh::Program& program = *statistics.program();
    const PlaceCounts& counts = statistics.at(place);
    QJsonObject object = placeObject(program, place, "element");
    object["type"] = typeOf(program.places[place].kind);
    const auto put = [&object](const char* key, std::uint64_t count) { object[key] = static_cast<qint64>(count); };
    if (isSense(program.places[place].kind)) {
        put("asked", counts.asked);
        put("held", counts.held);
        return object;
    }
    object["time_s"] = seconds(counts.active_ms);
    object["time_pct"] = share_pct(statistics, place);
    put("cycles", counts.runs);
    put("started", counts.started);
    put("succeeded", counts.succeeded);
    put("failed", counts.failed);
    put("interrupted", counts.interrupted);
    put("skipped", counts.skipped);
    if (counts.spent_ns > 0) {
        object["spent_ms"] = milliseconds(counts.spent_ns);
        object["longest_ms"] = milliseconds(counts.longest_ns);
    }
    return object;
}

} // namespace

std::string runReportText(const posh::RunStatistics& statistics, int runs) {
    const posh::Program& program = *statistics.program();
    std::string text = program.title + ": " + counted(static_cast<std::uint64_t>(runs), "run", "runs") + ", " +
                       counted(statistics.cycles(), "cycle", "cycles") + ", " +
                       fixed(seconds(statistics.at(0).active_ms), 1) + " s\n";
    for (const posh::RunFinding& finding : posh::reportOn(statistics))
        text += "  " + std::string(posh::toText(finding.remark)) + ": " + finding.message + '\n';
    text += "Time:\n";
    for (Index place = 1; place < program.places.size(); ++place)
        if (!isSense(program.places[place].kind) && statistics.at(place).started > 0)
            text += lineOf(statistics, place);
    return text;
}

QByteArray runReportJson(const posh::RunStatistics& statistics, int runs) {
    const posh::Program& program = *statistics.program();
    QByteArray lines = jsonLine({{"kind", "plan"},
                                 {"plan", QString::fromStdString(program.title)},
                                 {"runs", runs},
                                 {"cycles", static_cast<qint64>(statistics.cycles())},
                                 {"time_s", seconds(statistics.at(0).active_ms)}});
    for (const posh::RunFinding& finding : posh::reportOn(statistics)) {
        QJsonObject object = placeObject(program, finding.place, "finding");
        object["remark"] = QString::fromUtf8(posh::toText(finding.remark));
        object["message"] = QString::fromStdString(finding.message);
        lines += jsonLine(object);
    }
    for (Index place = 1; place < program.places.size(); ++place)
        lines += jsonLine(elementObject(statistics, place));
    return lines;
}

Result<void> saveRunReport(const posh::RunStatistics& statistics, const QString& path) {
    const bool for_programs = path.endsWith(".jsonl") || path.endsWith(".json");
    const QByteArray bytes =
        for_programs ? runReportJson(statistics, 1) : QByteArray::fromStdString(runReportText(statistics, 1));
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit())
        return {};
    return failure("the report cannot be written: " + file.errorString().toStdString(), path.toStdString(),
                   "Choose another place");
}

} // namespace usar::mission
