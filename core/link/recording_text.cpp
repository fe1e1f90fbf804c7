#include "core/link/recording_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "core/base/quoted_text.h"
#include "core/base/text.h"
#include "core/link/recording_packing.h"
#include "core/link/recording_reader.h"

namespace usar::link {

namespace {

using KindWord = std::pair<RecordKind, std::string_view>;
constexpr std::array<KindWord, 7> kind_words{{{RecordKind::Start, "start"},
                                              {RecordKind::Opened, "opened"},
                                              {RecordKind::Closed, "closed"},
                                              {RecordKind::In, "in"},
                                              {RecordKind::Out, "out"},
                                              {RecordKind::Note, "note"},
                                              {RecordKind::End, "end"}}};
constexpr std::int64_t nanoseconds_a_second = 1'000'000'000;

std::string wordOf(RecordKind kind) {
    const auto known = std::ranges::find(kind_words, kind, &KindWord::first);
    return known == kind_words.end() ? std::to_string(static_cast<unsigned>(kind)) : std::string(known->second);
}

template <class Integer>
bool readWhole(std::string_view word, Integer& value) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size() && !word.empty();
}

bool readKind(std::string_view word, RecordKind& kind) {
    const auto known = std::ranges::find(kind_words, word, &KindWord::second);
    unsigned number = 0;
    if (known != kind_words.end())
        kind = known->first;
    else if (readWhole(word, number) && number > 0 && number <= 255)
        kind = static_cast<RecordKind>(number);
    else
        return false;
    return true;
}

void appendSeconds(std::string& text, RecordTime time) {
    const auto whole = static_cast<std::uint64_t>(time.count());
    const std::string fraction = std::to_string(whole % nanoseconds_a_second);
    text += std::to_string(whole / nanoseconds_a_second) + '.' + std::string(9 - fraction.size(), '0') + fraction;
}

bool readSeconds(std::string_view word, RecordTime& time) {
    const auto point = word.find('.');
    std::uint64_t seconds = 0;
    std::uint64_t fraction = 0;
    if (point == std::string_view::npos || word.size() - point != 10 || !readWhole(word.substr(0, point), seconds) ||
        !readWhole(word.substr(point + 1), fraction) || seconds > UINT64_MAX / nanoseconds_a_second - 1)
        return false;
    time = RecordTime(static_cast<std::int64_t>(seconds * nanoseconds_a_second + fraction));
    return true;
}

constexpr std::size_t chunk_bytes = 1u << 20;

/// Writes the batch and empties it, if it has at least so many bytes.
Result<void> hand(std::string& batch, QIODevice& to, std::size_t least_bytes = 0) {
    if (batch.size() < least_bytes)
        return {};
    if (to.write(batch.data(), static_cast<qint64>(batch.size())) != static_cast<qint64>(batch.size()))
        return failure("writing failed: " + to.errorString().toStdString(), "the output",
                       "Is there room left, and does somebody read it");
    batch.clear();
    return {};
}

std::string_view withoutEnd(const QByteArray& line) {
    std::string_view text(line.constData(), static_cast<std::size_t>(line.size()));
    while (text.ends_with('\n') || text.ends_with('\r'))
        text.remove_suffix(1);
    return text;
}

} // namespace

void recording::appendText(std::string& text, const Record& record) {
    text += wordOf(record.kind) + ' ';
    appendSeconds(text, record.time);
    text += ' ' + std::to_string(record.line.value) + ' ';
    if (record.kind == RecordKind::Out || record.kind == RecordKind::Note) {
        text += std::to_string(record.trigger.value) + ' ';
        appendQuoted(text, record.name);
        text += ' ';
    }
    appendQuoted(text, record.bytes);
    text += '\n';
}

Result<Record> recording::TextRecord::read(std::string_view line) {
    std::string_view rest = line;
    const auto wrong = [&](std::string what, std::string mend) {
        return failure(std::move(what), "column " + std::to_string(line.size() - rest.size() + 1), std::move(mend));
    };
    Record record;
    if (!readKind(takeWord(rest), record.kind))
        return wrong("the line does not begin with a kind of record",
                     "Write start, opened, closed, in, out, note, end or a number from 1 to 255");
    if (!readSeconds(takeWord(rest), record.time))
        return wrong("the time is not seconds with nine decimals", "Write for example 12.345000000");
    if (!readWhole(takeWord(rest), record.line.value))
        return wrong("the line number is not a whole number", "Write the number of the newest info line, or 0");
    if (record.kind == RecordKind::Out || record.kind == RecordKind::Note) {
        if (!readWhole(takeWord(rest), record.trigger.value))
            return wrong("the triggering line is not a whole number", "Write its number, or 0");
        if (!takeQuoted(rest, name_) || name_.size() > 0xFFFF)
            return wrong("the name is not a text in quotes", "Write for example \"session: connect\"");
        record.name = name_;
    }
    if (!takeQuoted(rest, bytes_) || !trimmed(rest).empty())
        return wrong("the bytes are not one text in quotes at the end of the line",
                     "Escape quotes inside it as \\\" and backslashes as \\\\");
    record.bytes = bytes_;
    return record;
}

Result<void> recordingToText(const QString& recording_path, QIODevice& text) {
    const auto reader = RecordingReader::open(recording_path);
    if (!reader)
        return tl::unexpected(reader.error());
    std::string batch(recording::text_title);
    batch += '\n';
    const RecordingSurvey& survey = (*reader)->survey();
    auto damage = survey.damage.begin();
    const auto damage_end = survey.damage.end();
    const auto noteDamage = [&](std::uint64_t before) {
        for (; damage != damage_end && damage->offset < before; ++damage) {
            const RecordingPlace place = survey.placeOf(damage->offset);
            batch += "# " + std::to_string(damage->bytes) + " damaged bytes at byte " + std::to_string(place.offset) +
                     (survey.files.size() > 1 ? " of " + place.file : std::string()) + '\n';
        }
    };
    while (const auto record = (*reader)->next()) {
        noteDamage((*reader)->offset());
        recording::appendText(batch, *record);
        if (auto handed = hand(batch, text, chunk_bytes); !handed)
            return handed;
    }
    noteDamage(UINT64_MAX);
    return hand(batch, text);
}

Result<void> textToRecording(QIODevice& text, const QString& text_name, QIODevice& recording) {
    const auto at = [&](std::uint64_t line) { return text_name.toStdString() + ", line " + std::to_string(line); };
    if (withoutEnd(text.readLine()) != recording::text_title)
        return failure("this is not the text form of a recording", at(1),
                       "Its first line must be \"" + std::string(recording::text_title) + "\"");
    std::string batch;
    recording::appendHead(batch);
    BlockWriter blocks(batch.size());
    RecordPacker packer;
    recording::TextRecord reader;
    for (std::uint64_t number = 2;; ++number) {
        const QByteArray bytes = text.readLine();
        if (bytes.isEmpty()) { // Unlike atEnd(), which a pipe reports too early.
            blocks.append(batch, packer.take());
            blocks.appendIndex(batch);
            return hand(batch, recording);
        }
        const std::string_view line = withoutEnd(bytes);
        if (trimmed(line).empty() || line.starts_with('#'))
            continue;
        const auto record = reader.read(line);
        if (!record)
            return failure(record.error().what, at(number) + ", " + record.error().where, record.error().mend);
        packer.add(*record);
        if (packer.size() >= chunk_bytes)
            blocks.append(batch, packer.take());
        if (auto handed = hand(batch, recording, chunk_bytes); !handed)
            return handed;
    }
}

} // namespace usar::link
