#include "core/mission/reports/line_report.h"

#include <algorithm>
#include <cstring>
#include <deque>
#include <future>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include <QString>

#include "core/base/text.h"
#include "core/base/type_name.h"
#include "core/mission/files/json_pen.h"
#include "core/mission/session/stream_name.h"
#include "core/protocol/command_grammar.h"
#include "core/protocol/command_reader.h"
#include "core/protocol/described_fields.h"
#include "core/protocol/field_list.h"
#include "core/protocol/fields.h"
#include "core/protocol/line_splitter.h"

namespace usar::mission {

namespace {

constexpr qint64 block_bytes = 1 << 20;
constexpr std::size_t batch_bytes = 1 << 20;

/// Writes each value as an element of a JSON array as soon as it is listed.
class WrittenFields : public protocol::FieldList {
public:
    explicit WrittenFields(JsonPen& pen) : pen_(pen) {}

protected:
    void put(const protocol::FieldView& field) override {
        open(field.item, field.field, field.unit);
        pen_.raw(",\"value\":");
        if (field.number)
            pen_.number(*field.number);
        else
            pen_.text(field.text);
        pen_.raw("}");
    }
    bool putList(std::string_view field, std::span<const double> values, std::string_view unit) override {
        open(item, field.empty() ? "values" : field, unit);
        pen_.raw(",\"values\":[");
        bool first = true;
        for (const double value : values) {
            pen_.next(first);
            pen_.number(value);
        }
        pen_.raw("]}");
        return true;
    }

private:
    void open(std::string_view item, std::string_view field, std::string_view unit) {
        pen_.next(first_);
        pen_.raw("{\"field\":");
        pen_.text(field);
        if (!item.empty()) {
            pen_.raw(",\"item\":");
            pen_.text(item);
        }
        if (!unit.empty()) {
            pen_.raw(",\"unit\":");
            pen_.utf8(unit);
        }
    }

    JsonPen& pen_;
    bool first_ = true;
};

std::string_view nameOf(Severity severity) {
    return severity == Severity::Note ? "note" : severity == Severity::Warning ? "warning" : "error";
}

void writeDiagnostics(JsonPen& pen, const Diagnostics& diagnostics) {
    pen.raw(",\"diagnostics\":[");
    bool first = true;
    for (const Diagnostic& diagnostic : diagnostics) {
        pen.next(first);
        pen.raw("{\"severity\":");
        pen.text(nameOf(diagnostic.severity));
        pen.raw(",\"column\":");
        pen.number(static_cast<std::uint64_t>(diagnostic.offset + 1));
        pen.raw(",\"message\":");
        pen.utf8(QString::fromStdString(diagnostic.message).toStdString()); // It may quote bytes of the line.
        pen.raw("}");
    }
    pen.raw("]");
}

bool isCommand(std::string_view text) {
    static const std::set<std::string, std::less<>> words = [] {
        std::set<std::string, std::less<>> all;
        for (const protocol::CommandRule& rule : protocol::commandRules())
            all.insert(lowerCase(rule.word));
        return all;
    }();
    return words.contains(lowerCase(trimmed(text.substr(0, text.find('{')))));
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

void open(JsonPen& pen, std::uint64_t line, std::string_view direction, std::string_view type,
          std::string_view container) {
    pen.raw("{\"line\":");
    pen.number(line);
    pen.raw(",\"direction\":");
    pen.text(direction);
    pen.raw(",\"type\":");
    pen.text(type);
    pen.raw(",\"container\":");
    pen.text(container);
}

bool reportCommand(JsonPen& pen, std::string_view text, std::uint64_t line) {
    Diagnostics diagnostics;
    const protocol::Command command = protocol::readCommand(text, diagnostics);
    const protocol::GenericMessage segments = segmentsOf(text);
    const std::string_view container =
        std::visit([]<class T>(const T&) -> std::string_view { return typeName<T>(); }, command);
    open(pen, line, "out",
         sameWord(segments.type_word, "set") ? segments.type_word + " " + segments.type : segments.type_word,
         container);
    pen.raw(",\"fields\":[");
    WrittenFields fields(pen);
    protocol::listGenericFields(segments, fields);
    pen.raw("]");
    writeDiagnostics(pen, diagnostics);
    return !diagnostics.empty();
}

template <class Owner>
bool hasItem(std::string_view key) {
    bool found = false;
    protocol::forEachItem<Owner>([&](const auto& item) {
        if constexpr (requires { item.key; })
            found |= sameWord(item.key, key) || (!item.other_key.empty() && sameWord(item.other_key, key));
        else
            found |= sameWord(key, "Location") || sameWord(key, "Orientation") || sameWord(key, "Rotation");
    });
    return found;
}

/// True if lines of this kind have the key, or if the kind has a reader of its own, which knows.
template <class Message>
bool hasKey(std::string_view key) {
    if constexpr (protocol::SensorMessage<Message> && protocol::Described<Message>) {
        if (sameWord(key, "Name") || sameWord(key, "Time") || sameWord(key, "Type") || hasItem<Message>(key))
            return true;
        if constexpr (protocol::HasGroups<Message>) {
            constexpr auto groups = Message::groups();
            using Element = decltype(protocol::elementOf(groups));
            return sameWord(groups.opening_key, key) ||
                   (!groups.other_key.empty() && sameWord(groups.other_key, key)) || hasItem<Element>(key);
        }
        return false;
    }
    return true;
}

/// Words that the server sent and no struct has a place for.
void writeUnread(JsonPen& pen, std::string_view text, const protocol::InfoMessage& message) {
    const auto has_key = std::visit([]<class One>(const One&) { return &hasKey<One>; },
                                    static_cast<const protocol::InfoVariant&>(message));
    if (has_key("?"))
        return;
    thread_local protocol::Segments segments;
    thread_local Diagnostics ignored;
    ignored.clear();
    segments.read(text, ignored);
    bool first = true;
    const auto write = [&](std::string_view key, std::string_view value) {
        if (has_key(key))
            return;
        pen.raw(first ? ",\"unread\":[" : ",");
        first = false;
        pen.raw("{\"key\":");
        pen.text(key);
        pen.raw(",\"value\":");
        pen.text(value);
        pen.raw("}");
    };
    for (const protocol::Segment& segment : segments.all()) {
        write(segment.key, segment.value);
        if (!sameWord(segment.key, "Name"))
            continue;
        protocol::NamedPairs pairs(segment.value);
        std::string_view key, value;
        while (pairs.next(key, value))
            write(key, value);
    }
    if (!first)
        pen.raw("]");
}

bool reportInfo(JsonPen& pen, std::string_view text, const protocol::InfoLine& read, std::uint64_t line) {
    open(pen, line, "in", streamName(read.message), protocol::containerOf(read.message));
    if (const auto time = protocol::timeOf(read.message)) {
        pen.raw(",\"time\":");
        pen.number(time->count());
    }
    pen.raw(",\"fields\":[");
    WrittenFields fields(pen);
    protocol::listFields(read.message, fields);
    pen.raw("]");
    writeUnread(pen, text, read.message);
    writeDiagnostics(pen, read.diagnostics);
    return !read.diagnostics.empty();
}

/// Cuts blocks of a log into numbered lines, and drops what exceeds the cap of a line.
class LogLines {
public:
    explicit LogLines(QIODevice& input) : input_(input), block_(block_bytes, '\0') {}

    /// Calls `take(text, number, too_long)` for each line, with what is there of it, until one call returns false.
    template <class Take>
    void each(Take take) {
        bool goes_on = true;
        while (goes_on) {
            const qint64 count = input_.read(block_.data(), static_cast<qint64>(block_.size()));
            if (count <= 0)
                break;
            std::string_view rest(block_.data(), static_cast<std::size_t>(count));
            while (goes_on && !rest.empty()) {
                const auto* const end = static_cast<const char*>(std::memchr(rest.data(), '\n', rest.size()));
                const std::string_view part =
                    rest.substr(0, end ? static_cast<std::size_t>(end - rest.data()) : rest.size());
                rest.remove_prefix(std::min(rest.size(), part.size() + 1));
                if (!end || !begun_.empty())
                    keep(part);
                if (end)
                    goes_on = finish(part, take);
            }
        }
        if (goes_on && !begun_.empty())
            finish({}, take);
    }

private:
    void keep(std::string_view part) {
        constexpr std::size_t cap = protocol::LineSplitter::default_cap_bytes;
        too_long_ |= begun_.size() + part.size() > cap;
        begun_.append(part.substr(0, cap - std::min(cap, begun_.size())));
    }

    template <class Take>
    bool finish(std::string_view whole, Take take) {
        const std::string_view line = begun_.empty() ? whole : std::string_view(begun_);
        const bool goes_on = take(trimmed(line), ++number_, too_long_);
        begun_.clear();
        too_long_ = false;
        return goes_on;
    }

    QIODevice& input_;
    std::string block_;
    std::string begun_; ///< what earlier blocks had of the current line
    bool too_long_ = false;
    std::uint64_t number_ = 0;
};

/// Lines that are reported on together, on one core.
struct Batch {
    struct Line {
        std::uint64_t number = 0;
        std::size_t size = 0; ///< `text` has this many bytes of the line
        bool too_long = false;
    };
    std::string text;
    std::vector<Line> lines;
};

struct Report {
    std::string json;
    LineCounts counts;
    std::uint64_t last_number = 0;
};

Report reportBatch(const Batch& batch) {
    protocol::Reader reader; // It carries nothing over from line to line but their number, which is not reported.
    Report report;
    std::string_view rest = batch.text;
    for (const Batch::Line& line : batch.lines) {
        ++report.counts.lines;
        report.last_number = line.number;
        if (line.too_long) {
            JsonPen pen(report.json);
            open(pen, line.number, "in", "", "");
            pen.raw(",\"fields\":[]");
            writeDiagnostics(pen, {{Severity::Error, 0, "the line is longer than 4 MiB"}});
            pen.raw("}\n");
            ++report.counts.with_diagnostics;
            continue;
        }
        report.counts.with_diagnostics +=
            reportLine(reader, rest.substr(0, line.size), line.number, report.json) ? 1 : 0;
        rest.remove_prefix(line.size);
    }
    return report;
}

} // namespace

bool reportLine(protocol::Reader& reader, std::string_view text, std::uint64_t line, std::string& out) {
    JsonPen pen(out);
    const bool has_diagnostics =
        isCommand(text) ? reportCommand(pen, text, line) : reportInfo(pen, text, reader.read(text), line);
    pen.raw(",\"text\":");
    pen.text(text);
    pen.raw("}\n");
    return has_diagnostics;
}

Result<LineCounts> reportLines(QIODevice& input, QIODevice& output) {
    LineCounts counts;
    bool written = true;
    std::uint64_t last_number = 0;
    std::deque<std::future<Report>> reports; // in the order of the lines
    const auto writeFirst = [&] {
        const Report report = reports.front().get();
        reports.pop_front();
        counts.lines += report.counts.lines;
        counts.with_diagnostics += report.counts.with_diagnostics;
        last_number = report.last_number;
        const auto size = static_cast<qint64>(report.json.size());
        written = written && output.write(report.json.data(), size) == size;
    };
    const std::size_t most_reports = std::max(1U, std::thread::hardware_concurrency());
    Batch batch;
    const auto hand = [&] {
        if (reports.size() == most_reports)
            writeFirst();
        reports.push_back(std::async(std::launch::async, reportBatch, std::exchange(batch, {})));
    };
    LogLines(input).each([&](std::string_view text, std::uint64_t number, bool too_long) {
        if (text.empty() || text.starts_with('#'))
            return true;
        batch.lines.push_back({number, too_long ? 0 : text.size(), too_long});
        if (!too_long)
            batch.text.append(text);
        if (batch.text.size() >= batch_bytes)
            hand();
        return written;
    });
    hand();
    while (!reports.empty())
        writeFirst();
    if (!written)
        return failure("the output cannot be written: " + output.errorString().toStdString(),
                       "line " + std::to_string(last_number), "Make room, or write elsewhere");
    return counts;
}

} // namespace usar::mission
