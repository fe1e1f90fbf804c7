#include "widgets/models/messages/message_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QJsonArray>

#include "core/base/text.h"
#include "core/protocol/command_grammar.h"
#include "core/protocol/reader.h"
#include "core/protocol/segments.h"
#include "widgets/models/figures.h"

namespace usar::widgets {

namespace {

std::string helpOf(std::string_view word, std::string_view key) {
    for (const protocol::CommandRule& rule : protocol::commandRules())
        if (sameWord(rule.word, word))
            for (const protocol::SegmentRule& segment : rule.segments)
                if (sameWord(segment.key, key))
                    return std::string(segment.help);
    return {};
}

const char* wordOf(Severity severity) {
    return severity == Severity::Error ? "error" : severity == Severity::Warning ? "warning" : "note";
}

QJsonArray jsonOf(const std::vector<protocol::Field>& fields) {
    QJsonArray array;
    for (const protocol::Field& field : fields) {
        QJsonObject object{{"field", QString::fromUtf8(field.field)}};
        if (!field.item.empty())
            object["item"] = QString::fromUtf8(field.item);
        if (field.number)
            object["value"] = *field.number;
        else
            object["value"] = QString::fromUtf8(field.text);
        if (!field.unit.empty())
            object["unit"] = QString::fromUtf8(field.unit);
        array.append(object);
    }
    return array;
}

QJsonArray jsonOf(const Diagnostics& diagnostics) {
    QJsonArray array;
    for (const Diagnostic& diagnostic : diagnostics)
        array.append(QJsonObject{{"severity", wordOf(diagnostic.severity)},
                                 {"offset", static_cast<qint64>(diagnostic.offset)},
                                 {"message", QString::fromUtf8(diagnostic.message)}});
    return array;
}

} // namespace

MessageParts partsOf(const MessageRow& row) {
    constexpr std::size_t most_segments = 2000;
    MessageParts parts;
    if (row.not_shown > 0)
        return parts;
    const bool in = row.direction == Direction::In;
    if (in) {
        protocol::Reader reader;
        const protocol::InfoLine& line = reader.read(row.text);
        parts.fields = protocol::fieldsOf(line.message);
        parts.diagnostics = line.diagnostics;
        parts.known = !std::holds_alternative<protocol::GenericMessage>(line.message);
    } else {
        parts.diagnostics = protocol::checkCommand(row.text);
    }
    Diagnostics again; // Ignored: parts.diagnostics has them already.
    protocol::Segments segments;
    segments.read(row.text, again);
    for (const protocol::Segment& segment : segments.all().first(std::min(segments.all().size(), most_segments)))
        parts.segments.push_back({std::string(segment.key), std::string(segment.value),
                                  in ? std::string() : helpOf(segments.typeWord(), segment.key)});
    return parts;
}

QString valueText(const protocol::Field& field) {
    if (!field.number)
        return QString::fromUtf8(field.text);
    const QString number = QString::number(*field.number, 'g', 6);
    if (field.unit == "rad")
        return QStringLiteral("%1 rad (%2°)").arg(number, figure(*field.number * 180.0 / std::numbers::pi, 1));
    return field.unit.empty() ? number : number + u' ' + QString::fromUtf8(field.unit);
}

QString tabbedText(const MessageRow& row, const QString& robot) {
    if (row.not_shown > 0)
        return QString::fromUtf8(row.text);
    const QStringList cells{QString::number(row.number),
                            std::isfinite(row.time.count()) ? QString::number(row.time.count(), 'f', 2) : QString(),
                            robot,
                            row.direction == Direction::In ? QStringLiteral("in") : QStringLiteral("out"),
                            QString::fromUtf8(row.type),
                            QString::fromUtf8(row.text)};
    return cells.join(u'\t');
}

QJsonObject jsonOf(const MessageRow& row, const QString& robot) {
    if (row.not_shown > 0)
        return {{"lines_not_shown", static_cast<qint64>(row.not_shown)}};
    const MessageParts parts = partsOf(row);
    QJsonObject object{{"line", QString::fromUtf8(row.text)},
                       {"direction", row.direction == Direction::In ? "in" : "out"},
                       {"number", static_cast<qint64>(row.number)},
                       {"type", QString::fromUtf8(row.type)},
                       {"fields", jsonOf(parts.fields)},
                       {"diagnostics", jsonOf(parts.diagnostics)}};
    if (std::isfinite(row.time.count()))
        object["time_s"] = row.time.count();
    if (!robot.isEmpty())
        object["robot"] = robot;
    if (row.direction == Direction::Out)
        object["cause"] = QString::fromUtf8(row.note);
    if (row.trigger > 0)
        object["trigger"] = static_cast<qint64>(row.trigger);
    return object;
}

Pointer pointerAt(std::string_view text, std::size_t offset, int width) {
    offset = std::min(offset, text.size());
    const auto wide = static_cast<std::size_t>(width);
    const std::size_t last = text.size() - std::min(wide, text.size());
    const std::size_t from = std::min(offset - std::min(wide / 2, offset), last);
    const std::string_view part = text.substr(from, wide);
    Pointer pointer;
    for (const char c : part)
        pointer.excerpt += c >= ' ' && c < 0x7f ? QChar::fromLatin1(c) : QChar(u' ');
    if (from > 0)
        pointer.excerpt[0] = u'…';
    if (from + part.size() < text.size())
        pointer.excerpt.back() = u'…';
    pointer.caret = QString(static_cast<qsizetype>(offset - from), u' ') + u'^';
    return pointer;
}

} // namespace usar::widgets
