#include "core/link/recording_reader.h"

#include <algorithm>
#include <cerrno>

#include <sys/file.h>

#include "core/base/text.h"

namespace usar::link {

namespace {

constexpr std::size_t window_bytes = 2u << 20;
constexpr std::uint64_t index_step_bytes = 64u << 10;

std::string withUnit(std::uint64_t count, const char* one, const char* many) {
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

} // namespace

std::string RecordingSurvey::complaint() const {
    std::uint64_t lost = 0;
    for (const RecordingDamage& piece : damage)
        lost += piece.bytes;
    std::string text;
    if (lost > tail_lost_bytes)
        text = withUnit(lost - tail_lost_bytes, "byte is", "bytes are") + " damaged, the first at byte " +
               std::to_string(damage.front().offset) + ", and left out.";
    if (!ended && !being_written) {
        text += text.empty() ? "" : " ";
        text += "The recording was not ended in order; ";
        text += tail_lost_bytes > 0
                    ? "its last " + withUnit(tail_lost_bytes, "byte is", "bytes are") + " incomplete and left out."
                    : "up to a second before its end may be missing.";
    }
    return text;
}

Result<std::unique_ptr<RecordingReader>> RecordingReader::open(const QString& path) {
    std::unique_ptr<RecordingReader> reader(new RecordingReader);
    reader->path_ = path.toStdString();
    reader->file_.setFileName(path);
    if (!reader->file_.open(QIODevice::ReadOnly | QIODevice::Unbuffered))
        return failure(reader->file_.errorString().toStdString(), reader->path_,
                       "Check the name, and whether the file may be read");
    reader->survey_.being_written = reader->writerLives(); // Must come before asking for the file size.
    if (auto head = reader->readHead(); !head)
        return tl::unexpected(head.error());
    reader->surveyAll();
    reader->judgeEnd();
    if (reader->survey_.records == 0)
        return failure("it holds not one whole record after byte " + std::to_string(recording::head_bytes),
                       reader->path_, "It ended before anything was recorded; record again");
    reader->seek(RecordTime{0});
    return reader;
}

/// A writer holds a lock on its file for as long as it runs.
bool RecordingReader::writerLives() {
    if (::flock(file_.handle(), LOCK_SH | LOCK_NB) == 0) {
        ::flock(file_.handle(), LOCK_UN);
        return false;
    }
    return errno == EWOULDBLOCK;
}

Result<void> RecordingReader::readHead() {
    survey_.file_bytes = static_cast<std::uint64_t>(std::max<qint64>(file_.size(), 0));
    const std::string_view head = at(0, recording::head_bytes).substr(0, recording::head_bytes);
    if (head.empty())
        return failure("the file is empty", path_, "Nothing was recorded; record again");
    if (!recording::magic.starts_with(head.substr(0, recording::magic.size())))
        return failure("byte 0 does not begin a recording", path_,
                       "Give a .usarrec file; a text form becomes one with usar-mission text-to-recording");
    if (head.size() < recording::head_bytes)
        return failure("it ends at byte " + std::to_string(head.size()) + ", before anything was recorded", path_,
                       "Record again");
    std::string ours;
    recording::appendHead(ours);
    if (head != ours)
        return failure("byte 8 says a version of recordings that this program does not know", path_,
                       "Open it with a newer program");
    position_ = recording::head_bytes;
    return {};
}

void RecordingReader::surveyAll() {
    PlayClock clock;
    while (const auto record = find(&survey_.damage)) {
        survey_.play_span = clock.at(*record);
        if (const auto now = clock.now(); now && record->kind == RecordKind::In)
            survey_.clock.add(survey_.play_span, *now);
        if (survey_.records++ == 0)
            survey_.first_line = record->line;
        if (index_.empty() || record_offset_ - index_.back().offset >= index_step_bytes)
            index_.push_back({record->time, record_offset_});
        survey_.span = record->time;
        if (record->kind == RecordKind::In)
            survey_.bytes_in += record->bytes.size();
        if (record->kind == RecordKind::Out)
            survey_.bytes_out += record->bytes.size();
        survey_.commands += record->kind == RecordKind::Out;
        survey_.ended = record->kind == RecordKind::End;
        if (record->kind == RecordKind::Start)
            takeFacts(record->bytes);
    }
}

void RecordingReader::judgeEnd() {
    survey_.being_written = survey_.being_written && !survey_.ended;
    if (!survey_.damage.empty() && survey_.damage.back().offset + survey_.damage.back().bytes == survey_.file_bytes) {
        survey_.ended = false;
        if (survey_.being_written)
            survey_.damage.pop_back(); // The rest of that record is still being written.
        else
            survey_.tail_lost_bytes = survey_.damage.back().bytes;
    }
}

void RecordingReader::takeFacts(std::string_view text) {
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        if (const auto colon = line.find(':'); colon != std::string_view::npos)
            survey_.facts[std::string(line.substr(0, colon))] = trimmed(line.substr(colon + 1));
    }
}

void RecordingReader::seek(RecordTime time) {
    const auto after = std::ranges::lower_bound(index_, time, {}, &Entry::time);
    const Entry from = after == index_.begin() ? Entry{{}, recording::head_bytes} : *std::prev(after);
    position_ = from.offset;
    newest_ = from.time;
    while (position_ < survey_.file_bytes) {
        const auto record = find(nullptr);
        if (record && record->time < time)
            continue;
        position_ = record ? record_offset_ : survey_.file_bytes;
        return;
    }
}

std::optional<Record> RecordingReader::find(std::vector<RecordingDamage>* damage) {
    while (position_ < survey_.file_bytes) {
        if (const auto end = damage ? std::nullopt : endOfKnownDamage()) {
            position_ = *end;
            continue;
        }
        std::string_view bytes = at(position_, recording::record_head_bytes);
        if (const auto size = recording::sizeAt(bytes))
            bytes = at(position_, *size);
        recording::Taken taken = recording::take(bytes);
        if (taken.fit == recording::Fit::Whole) {
            record_offset_ = position_;
            position_ += taken.size;
            newest_ = taken.record.time = std::max(newest_, taken.record.time);
            return taken.record;
        }
        const std::uint64_t good = nextWhole(position_ + 1).value_or(survey_.file_bytes);
        if (damage)
            damage->push_back({position_, good - position_});
        position_ = good;
    }
    return std::nullopt;
}

std::optional<std::uint64_t> RecordingReader::endOfKnownDamage() const {
    const auto known = std::ranges::lower_bound(survey_.damage, position_, {}, &RecordingDamage::offset);
    const bool begins_here = known != survey_.damage.end() && known->offset == position_;
    return begins_here ? std::optional(known->offset + known->bytes) : std::nullopt;
}

std::optional<std::uint64_t> RecordingReader::nextWhole(std::uint64_t offset) {
    for (; offset + recording::record_head_bytes <= survey_.file_bytes; ++offset) {
        const auto size = recording::sizeAt(at(offset, recording::record_head_bytes));
        if (!size || offset + *size > survey_.file_bytes)
            continue;
        if (*size > scents_left_bytes_)
            return std::nullopt;
        scents_left_bytes_ -= *size;
        if (recording::take(at(offset, *size)).fit == recording::Fit::Whole)
            return offset;
    }
    return std::nullopt;
}

std::string_view RecordingReader::at(std::uint64_t offset, std::size_t least) {
    const bool inside = offset >= window_offset_ && offset <= window_offset_ + window_.size();
    if (!inside || window_offset_ + window_.size() - offset < least) {
        window_.resize(std::max(window_bytes, least));
        window_offset_ = offset;
        qint64 got = 0;
        if (file_.seek(static_cast<qint64>(offset)))
            got = file_.read(window_.data(), static_cast<qint64>(window_.size()));
        window_.resize(static_cast<std::size_t>(std::max<qint64>(got, 0)));
    }
    return std::string_view(window_).substr(static_cast<std::size_t>(offset - window_offset_));
}

} // namespace usar::link
