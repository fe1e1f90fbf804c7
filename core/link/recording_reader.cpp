#include "core/link/recording_reader.h"

#include <algorithm>
#include <utility>

#include "core/base/numbers.h"
#include "core/link/recording_parts.h"

namespace usar::link {

namespace {

/// Each part keeps its file open. A limit has room for ten, and for more only if it was changed while they were
/// written.
constexpr std::size_t most_parts = 64;

/// Chooses the source by the version that the head names.
Result<std::unique_ptr<RecordSource>> sourceOf(RecordingFile& file, const std::string& path) {
    const std::string_view head = file.at(0, recording::head_bytes).substr(0, recording::head_bytes);
    if (head.empty())
        return failure("the file is empty", path, "Nothing was recorded; record again");
    if (!recording::magic.starts_with(head.substr(0, recording::magic.size())))
        return failure("byte 0 does not begin a recording", path,
                       "Give a .usarrec file; a text form becomes one with usar-mission text-to-recording");
    if (head.size() < recording::head_bytes)
        return failure("it ends at byte " + std::to_string(head.size()) + ", before anything was recorded", path,
                       "Record again");
    const std::uint32_t version = recording::versionIn(head);
    if (version != recording::plain_version && version != recording::packed_version)
        return failure("byte 8 says a version of recordings that this program does not know", path,
                       "Open it with a newer program");
    return version == recording::plain_version ? plainSource(file) : packedSource(file);
}

void judgeEnd(RecordingSurvey& survey) {
    survey.being_written = survey.being_written && !survey.ended;
    if (!survey.damage.empty() && survey.damage.back().offset + survey.damage.back().bytes == survey.file_bytes) {
        survey.ended = false;
        if (survey.being_written)
            survey.damage.pop_back(); // The rest of that record is still being written.
        else
            survey.tail_lost_bytes = survey.damage.back().bytes;
    }
}

std::string factIn(const RecordingSurvey& survey, const char* name) {
    const auto fact = survey.facts.find(name);
    return fact == survey.facts.end() ? std::string() : fact->second;
}

/// 1 for a recording that is not in parts.
int partNumberOf(const RecordingSurvey& survey) {
    constexpr std::int64_t most = 1'000'000'000;
    return static_cast<int>(std::clamp<std::int64_t>(readInteger(factIn(survey, "part")).value_or(1), 1, most));
}

/// When the whole recording began, which its parts have in common.
std::string beginningOf(const RecordingSurvey& survey) {
    const std::string began = factIn(survey, "began");
    return began.empty() ? factIn(survey, "started") : began;
}

} // namespace

Result<RecordingReader::Part> RecordingReader::openPart(const QString& path, OpenMode mode) {
    Part part;
    part.file = std::make_unique<RecordingFile>();
    const std::string name = path.toStdString();
    if (!part.file->open(path))
        return failure(part.file->errorString().toStdString(), name,
                       "Check the name, and whether the file may be read");
    const bool being_written = part.file->writerLives(); // Must come before asking for the file size.
    part.file->measure();
    auto source = sourceOf(*part.file, name);
    if (!source)
        return tl::unexpected(source.error());
    part.source = *std::move(source);
    part.survey = part.source->survey(mode == OpenMode::Thorough);
    part.survey.being_written = being_written;
    part.survey.file_bytes = part.file->size();
    judgeEnd(part.survey);
    if (part.survey.records == 0)
        return failure("it holds not one whole record after byte " + std::to_string(recording::head_bytes), name,
                       "It ended before anything was recorded; record again");
    return part;
}

Result<std::unique_ptr<RecordingReader>> RecordingReader::open(const QString& path, OpenMode mode) {
    auto opened = openPart(path, mode);
    if (!opened)
        return tl::unexpected(opened.error());
    std::vector<Part> parts; // The newest comes first here.
    parts.push_back(*std::move(opened));
    const QString recording = recordingOfPart(path);
    for (int number = partNumberOf(parts.back().survey) - 1; number > 0 && parts.size() < most_parts; --number) {
        auto earlier = openPart(partPath(recording, number), mode);
        if (!earlier || partNumberOf(earlier->survey) != number ||
            beginningOf(earlier->survey) != beginningOf(parts.back().survey))
            break;
        parts.push_back(*std::move(earlier));
    }
    std::ranges::reverse(parts);
    return std::unique_ptr<RecordingReader>(new RecordingReader(std::move(parts), path.toStdString()));
}

RecordingReader::RecordingReader(std::vector<Part> parts, std::string path)
    : path_(std::move(path))
    , parts_(std::move(parts)) {
    for (Part& part : parts_) {
        part.begin = std::min(survey_.span, PlayClock::longest);
        part.begin_bytes = survey_.file_bytes;
        if (&part == &parts_.front())
            survey_ = std::move(part.survey);
        else
            survey_.append(part.survey);
    }
    survey_.parts_lost = partNumberOf(survey_) - 1;
    seek(RecordTime{0});
}

void RecordingReader::seek(RecordTime time) {
    const auto after =
        std::find_if(parts_.begin() + 1, parts_.end(), [time](const Part& part) { return part.begin >= time; });
    now_ = static_cast<std::size_t>(after - parts_.begin()) - 1;
    parts_[now_].source->seek(time - parts_[now_].begin);
}

std::optional<Record> RecordingReader::next() {
    while (true) {
        met_.clear();
        const Part& part = parts_[now_];
        auto record = part.source->next(&met_);
        for (const RecordingDamage& piece : met_)
            addDamage({part.begin_bytes + piece.offset, piece.bytes});
        if (record && now_ > 0)
            record->time = part.begin + std::min(record->time, PlayClock::longest);
        if (record || now_ + 1 == parts_.size())
            return record;
        parts_[++now_].source->seek(RecordTime{0});
    }
}

void RecordingReader::addDamage(const RecordingDamage& piece) {
    const bool on_its_way = survey_.being_written && piece.offset + piece.bytes == survey_.file_bytes;
    const auto after = std::ranges::lower_bound(survey_.damage, piece.offset, {}, &RecordingDamage::offset);
    const bool known = after != survey_.damage.end() && after->offset == piece.offset;
    if (!on_its_way && !known)
        survey_.damage.insert(after, piece);
}

} // namespace usar::link
