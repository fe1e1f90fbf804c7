#include "core/link/recording_chain.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <QFileInfo>

#include "core/base/numbers.h"
#include "core/link/recording_parts.h"

namespace usar::link {

namespace {

/// Each part keeps its file open, so that it can be read even if the limit has it deleted meanwhile. A limit has room
/// for ten, and for more only if it was changed while they were written.
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

Result<RecordingPart> openPart(const QString& path, OpenMode mode) {
    RecordingPart part;
    part.file = std::make_unique<RecordingFile>();
    part.name = QFileInfo(path).fileName().toStdString();
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
    part.source->rest();
    part.survey.being_written = being_written;
    part.survey.file_bytes = part.file->size();
    judgeEnd(part.survey);
    if (part.survey.records == 0)
        return failure("it holds not one whole record after byte " + std::to_string(recording::head_bytes), name,
                       "It ended before anything was recorded; record again");
    return part;
}

std::string factIn(const RecordingSurvey& survey, const char* name) {
    const auto fact = survey.facts.find(name);
    return fact == survey.facts.end() ? std::string() : fact->second;
}

/// When the whole recording began, which its parts have in common; empty if a file does not tell.
std::string beginningOf(const RecordingSurvey& survey) {
    const std::string began = factIn(survey, "began");
    return began.empty() ? factIn(survey, "started") : began;
}

bool areOfOneRecording(const RecordingPart& a, const RecordingPart& b) {
    const std::string began = beginningOf(a.survey);
    return !began.empty() && began == beginningOf(b.survey);
}

/// Opens the part of this number before `later`. An error tells in words that may follow "because".
Result<RecordingPart> openEarlier(const QString& recording, int number, const RecordingPart& later, OpenMode mode) {
    const QString path = partPath(recording, number);
    const std::string name = QFileInfo(path).fileName().toStdString();
    if (!QFileInfo::exists(path))
        return failure(name + " is gone or elsewhere", {}, {});
    auto part = openPart(path, mode);
    if (!part)
        return failure(name + " cannot be read (" + part.error().what + ")", {}, {});
    if (partNumberOf(part->survey) != number || !areOfOneRecording(*part, later))
        return failure(name + " is not a part of it", {}, {});
    return part;
}

/// A file is an earlier part if its name and its own beginning say so. The recording that it belongs to is named
/// otherwise then.
std::optional<QString> recordingItIsPartOf(const QString& path, const RecordingPart& part) {
    const auto name = readPartPath(path);
    return name && name->number == partNumberOf(part.survey) ? std::optional(name->recording) : std::nullopt;
}

/// Adds the parts before the one that the chain has, the newest first.
void addEarlier(const QString& path, OpenMode mode, RecordingChain& chain) {
    const int newest = partNumberOf(chain.parts.back().survey);
    // A recording may be called like a part of another one, and have parts of its own.
    QString recording = path;
    if (const auto whole = recordingItIsPartOf(path, chain.parts.back());
        whole && newest > 1 && !openEarlier(path, newest - 1, chain.parts.back(), OpenMode::Quick))
        recording = *whole;
    for (int number = newest - 1; number > 0; --number) {
        if (chain.parts.size() == most_parts) {
            chain.broken = "only its newest " + std::to_string(most_parts) + " are read";
            return;
        }
        auto earlier = openEarlier(recording, number, chain.parts.back(), mode);
        if (!earlier) {
            chain.broken = earlier.error().what;
            return;
        }
        chain.parts.push_back(*std::move(earlier));
    }
}

/// Tells it if later parts of an earlier one lie beside it.
std::string laterPartsOf(const QString& path, const RecordingPart& part) {
    const auto recording = recordingItIsPartOf(path, part);
    if (!recording)
        return {};
    const int number = partNumberOf(part.survey);
    for (const QString& later : {partPath(*recording, number + 1), *recording}) {
        const auto next = openPart(later, OpenMode::Quick);
        if (next && partNumberOf(next->survey) > number && areOfOneRecording(*next, part))
            return "This is an earlier part of the recording " + QFileInfo(*recording).fileName().toStdString() +
                   ", and what came after it is not read.";
    }
    return {};
}

/// Opens the newest part that lies beside a file which cannot be read.
Result<RecordingChain> openWithoutNewest(const QString& path, OpenMode mode, const Error& trouble) {
    RecordingChain chain;
    std::string not_read = QFileInfo(path).fileName().toStdString() + " (" + trouble.what + ')';
    std::vector<int> numbers = partNumbersBeside(path);
    for (; !numbers.empty(); numbers.pop_back()) {
        const QString earlier = partPath(path, numbers.back());
        auto part = openPart(earlier, mode);
        if (part && partNumberOf(part->survey) == numbers.back()) {
            chain.parts.push_back(*std::move(part));
            break;
        }
        not_read += ", " + QFileInfo(earlier).fileName().toStdString();
        not_read += part ? " (it is not a part of it)" : " (" + part.error().what + ')';
    }
    if (chain.parts.empty())
        return tl::unexpected(trouble);
    RecordingFile newest;
    chain.newest_begins = newest.open(path) && newest.writerLives();
    if (!chain.newest_begins)
        chain.not_read = "The end of this recording is missing, because nothing can be read in " + not_read + '.';
    return chain;
}

} // namespace

int partNumberOf(const RecordingSurvey& survey) {
    constexpr std::int64_t most = 1'000'000'000;
    return static_cast<int>(std::clamp<std::int64_t>(readInteger(factIn(survey, "part")).value_or(1), 1, most));
}

Result<RecordingChain> openRecordingChain(const QString& path, OpenMode mode) {
    RecordingChain chain;
    if (auto opened = openPart(path, mode)) {
        chain.parts.push_back(*std::move(opened));
        chain.later = laterPartsOf(path, chain.parts.back());
    } else {
        auto rest = openWithoutNewest(path, mode, opened.error());
        if (!rest)
            return rest;
        chain = *std::move(rest);
    }
    addEarlier(path, mode, chain);
    std::ranges::reverse(chain.parts);
    return chain;
}

} // namespace usar::link
