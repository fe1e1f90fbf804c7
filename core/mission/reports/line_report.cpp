#include "core/mission/reports/line_report.h"

#include <algorithm>
#include <string>
#include <vector>

#include <QJsonArray>

#include "core/base/text.h"
#include "core/base/type_name.h"
#include "core/mission/reports/json_line.h"
#include "core/mission/session/stream_name.h"
#include "core/protocol/command_grammar.h"
#include "core/protocol/command_reader.h"
#include "core/protocol/fields.h"
#include "core/protocol/line_splitter.h"

namespace usar::mission {

namespace {

QString shown(std::string_view text) {
    // Latin-1 is the encoding of the wire.
    return QString::fromLatin1(text);
}

QJsonArray toJson(const std::vector<protocol::Field>& fields) {
    QJsonArray array;
    for (const protocol::Field& field : fields) {
        QJsonObject object{{"field", shown(field.field)}};
        if (!field.item.empty())
            object["item"] = shown(field.item);
        object["value"] = field.number ? QJsonValue(*field.number) : QJsonValue(shown(field.text));
        if (!field.unit.empty())
            object["unit"] = QString::fromStdString(field.unit);
        array.append(object);
    }
    return array;
}

QString nameOf(Severity severity) {
    return severity == Severity::Note ? "note" : severity == Severity::Warning ? "warning" : "error";
}

QJsonArray toJson(const Diagnostics& diagnostics) {
    QJsonArray array;
    for (const Diagnostic& diagnostic : diagnostics)
        array.append(QJsonObject{{"severity", nameOf(diagnostic.severity)},
                                 {"column", static_cast<qint64>(diagnostic.offset) + 1},
                                 {"message", QString::fromStdString(diagnostic.message)}});
    return array;
}

bool isCommand(std::string_view text) {
    const std::string_view word = trimmed(text.substr(0, text.find('{')));
    return std::ranges::any_of(protocol::commandRules(),
                               [word](const protocol::CommandRule& rule) { return sameWord(rule.word, word); });
}

/// The segments of a command as they are on the wire. The command's own struct is meant for programs and uses another
/// frame.
protocol::GenericMessage segmentsOf(std::string_view text) {
    protocol::Segments segments;
    Diagnostics ignored;
    segments.read(text, ignored);
    protocol::GenericMessage message;
    message.type_word = segments.typeWord();
    message.type = segments.value("Type");
    for (const protocol::Segment& segment : segments.all())
        message.segments.push_back({std::string(segment.key), std::string(segment.value)});
    return message;
}

QJsonObject reportCommand(std::string_view text) {
    Diagnostics diagnostics;
    const protocol::Command command = protocol::readCommand(text, diagnostics);
    const protocol::GenericMessage segments = segmentsOf(text);
    const std::string_view container =
        std::visit([]<class T>(const T&) -> std::string_view { return typeName<T>(); }, command);
    return {{"direction", "out"},
            {"type", shown(lowerCase(segments.type_word) == "set" ? segments.type_word + " " + segments.type
                                                                  : segments.type_word)},
            {"container", shown(container)},
            {"fields", toJson(protocol::genericFieldsOf(segments))},
            {"diagnostics", toJson(diagnostics)}};
}

QJsonObject reportInfo(const protocol::InfoLine& line) {
    return {{"direction", "in"},
            {"type", shown(streamName(line.message))},
            {"container", shown(protocol::containerOf(line.message))},
            {"fields", toJson(protocol::fieldsOf(line.message))},
            {"diagnostics", toJson(line.diagnostics)}};
}

/// Reads up to the end of the line, however long it is, and drops what exceeds the cap.
QByteArray takeLine(QIODevice& input, bool& too_long) {
    constexpr qint64 cap = static_cast<qint64>(protocol::LineSplitter::default_cap_bytes);
    QByteArray line = input.readLine(cap);
    too_long = line.size() >= cap - 1 && !line.endsWith('\n');
    while (too_long) {
        const QByteArray rest = input.readLine(cap);
        if (rest.isEmpty() || rest.endsWith('\n'))
            break;
    }
    return line;
}

} // namespace

QJsonObject reportLine(protocol::Reader& reader, std::string_view text, std::uint64_t line) {
    QJsonObject object = isCommand(text) ? reportCommand(text) : reportInfo(reader.read(text));
    object["line"] = static_cast<qint64>(line);
    object["text"] = shown(text);
    return object;
}

Result<LineCounts> reportLines(QIODevice& input, QIODevice& output) {
    protocol::Reader reader;
    LineCounts counts;
    for (std::uint64_t number = 1;; ++number) {
        bool too_long = false;
        const QByteArray bytes = takeLine(input, too_long);
        if (bytes.isEmpty())
            break;
        const std::string_view text = trimmed({bytes.data(), static_cast<std::size_t>(bytes.size())});
        if (text.empty() || text.starts_with('#'))
            continue;
        QJsonObject object;
        if (too_long)
            object = {{"line", static_cast<qint64>(number)},
                      {"direction", "in"},
                      {"type", ""},
                      {"container", ""},
                      {"fields", QJsonArray()},
                      {"diagnostics", toJson(Diagnostics{{Severity::Error, 0, "the line is longer than 4 MiB"}})}};
        else
            object = reportLine(reader, text, number);
        ++counts.lines;
        counts.with_diagnostics += object["diagnostics"].toArray().isEmpty() ? 0 : 1;
        if (const auto printed = printLine(object, output, "line " + std::to_string(number)); !printed)
            return tl::unexpected(printed.error());
    }
    return counts;
}

} // namespace usar::mission
