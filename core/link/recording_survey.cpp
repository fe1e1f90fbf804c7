#include "core/link/recording_survey.h"

#include <algorithm>
#include <iterator>

#include "core/base/numbers.h"
#include "core/base/text.h"

namespace usar::link {

namespace {

// A damaged recording may claim any number of facts; what is beyond these is ignored.
constexpr std::size_t most_facts = 256;
constexpr std::size_t most_fact_bytes = 64u << 10; ///< of one record

std::string withUnit(std::uint64_t count, const char* one, const char* many) {
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

/// Puts a space between two texts if both are there.
std::string joined(const std::string& first, const std::string& second) {
    return first.empty() || second.empty() ? first + second : first + ' ' + second;
}

} // namespace

void RecordingSurvey::append(const RecordingSurvey& later) {
    clock.append(later.clock, play_span);
    constexpr RecordTime longest = PlayClock::longest;
    span = std::min(span, longest) + std::min(later.span, longest);
    play_span = std::min(play_span + later.play_span, longest);
    records += later.records;
    bytes_in += later.bytes_in;
    bytes_out += later.bytes_out;
    commands += later.commands;
    for (const RecordingDamage& piece : later.damage)
        damage.push_back({file_bytes + piece.offset, piece.bytes});
    file_bytes += later.file_bytes;
    tail_lost_bytes = later.tail_lost_bytes;
    ended = later.ended;
    being_written = later.being_written;
}

RecordingPlace RecordingSurvey::placeOf(std::uint64_t offset) const {
    const auto behind = std::ranges::upper_bound(files, offset, {}, &RecordingPlace::offset);
    if (behind == files.begin())
        return {{}, offset};
    return {std::prev(behind)->file, offset - std::prev(behind)->offset};
}

std::string RecordingSurvey::missingParts() const {
    if (parts_lost <= 0)
        return later;
    std::string text = parts_lost == 1
                           ? "The first part of this recording is missing"
                           : "The first " + std::to_string(parts_lost) + " parts of this recording are missing";
    if (!why_lost.empty())
        text += ", because " + why_lost;
    const auto after = facts.find("after_s");
    if (const auto late_s = after == facts.end() ? std::nullopt : readNumber(after->second))
        text += "; it begins " + fixed(*late_s, 0) + " s late";
    return joined(text + '.', later);
}

std::string RecordingSurvey::defects() const {
    std::uint64_t lost = 0;
    for (const RecordingDamage& piece : damage)
        lost += piece.bytes;
    std::string text = not_read;
    if (lost > tail_lost_bytes) {
        const RecordingPlace first = placeOf(damage.front().offset);
        text = joined(text, withUnit(lost - tail_lost_bytes, "byte is", "bytes are") + " damaged, the first at byte " +
                                std::to_string(first.offset) + (files.size() > 1 ? " of " + first.file : "") +
                                ", and left out.");
    }
    if (!ended && !being_written)
        text = joined(text, "The recording was not ended in order; " +
                                (tail_lost_bytes > 0 ? "its last " + withUnit(tail_lost_bytes, "byte is", "bytes are") +
                                                           " incomplete and left out."
                                                     : "up to a second before its end may be missing."));
    return text;
}

std::string RecordingSurvey::complaint() const {
    return joined(missingParts(), defects());
}

void RecordCounter::take(const Record& record) {
    survey_.play_span = clock_.at(record);
    if (const auto now = clock_.now(); now && record.kind == RecordKind::In)
        survey_.clock.add(survey_.play_span, *now);
    if (survey_.records++ == 0)
        survey_.first_line = record.line;
    survey_.span = record.time;
    if (record.kind == RecordKind::In)
        survey_.bytes_in += record.bytes.size();
    if (record.kind == RecordKind::Out)
        survey_.bytes_out += record.bytes.size();
    survey_.commands += record.kind == RecordKind::Out;
    survey_.ended = record.kind == RecordKind::End;
    if (record.kind == RecordKind::Start && survey_.facts.empty())
        takeFacts(record.bytes);
}

void RecordCounter::takeFacts(std::string_view text) {
    text = text.substr(0, most_fact_bytes);
    while (!text.empty() && survey_.facts.size() < most_facts) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        if (const auto colon = line.find(':'); colon != std::string_view::npos)
            survey_.facts[std::string(line.substr(0, colon))] = trimmed(line.substr(colon + 1));
    }
}

void RecordCounter::appendCounts(std::string& bytes) const {
    for (const std::uint64_t count :
         {survey_.records, survey_.bytes_in, survey_.bytes_out, survey_.commands, std::uint64_t{survey_.ended},
          static_cast<std::uint64_t>(survey_.span.count()), static_cast<std::uint64_t>(survey_.play_span.count())})
        appendVarint(bytes, count);
    clock_.appendTo(bytes);
}

void RecordCounter::appendState(std::string& bytes) {
    appendCounts(bytes);
    survey_.clock.appendTo(bytes, noted_stretches_);
    noted_stretches_ = survey_.clock.unchangingStretches();
}

void RecordCounter::appendWholeState(std::string& bytes) const {
    appendCounts(bytes);
    survey_.clock.appendTo(bytes, 0);
}

bool RecordCounter::continueFrom(ByteReader& bytes) {
    for (std::uint64_t* const count : {&survey_.records, &survey_.bytes_in, &survey_.bytes_out, &survey_.commands})
        *count = bytes.varint();
    survey_.ended = bytes.varint() != 0;
    survey_.span = RecordTime(static_cast<std::int64_t>(bytes.varint()));
    survey_.play_span = RecordTime(static_cast<std::int64_t>(bytes.varint()));
    return clock_.readFrom(bytes) && survey_.clock.readFrom(bytes) && survey_.span >= RecordTime::zero() &&
           survey_.play_span >= RecordTime::zero() && survey_.play_span <= PlayClock::longest;
}

} // namespace usar::link
