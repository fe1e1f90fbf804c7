#include "core/link/recording_reader.h"

#include <algorithm>

namespace usar::link {

Result<std::unique_ptr<RecordingReader>> RecordingReader::open(const QString& path, OpenMode mode) {
    std::unique_ptr<RecordingReader> reader(new RecordingReader);
    reader->path_ = path.toStdString();
    if (!reader->file_.open(path))
        return failure(reader->file_.errorString().toStdString(), reader->path_,
                       "Check the name, and whether the file may be read");
    const bool being_written = reader->file_.writerLives(); // Must come before asking for the file size.
    if (auto head = reader->readHead(); !head)
        return tl::unexpected(head.error());
    reader->survey_ = reader->source_->survey(mode == OpenMode::Thorough);
    reader->survey_.being_written = being_written;
    reader->survey_.file_bytes = reader->file_.size();
    reader->judgeEnd();
    if (reader->survey_.records == 0)
        return failure("it holds not one whole record after byte " + std::to_string(recording::head_bytes),
                       reader->path_, "It ended before anything was recorded; record again");
    reader->seek(RecordTime{0});
    return reader;
}

Result<void> RecordingReader::readHead() {
    file_.measure();
    const std::string_view head = file_.at(0, recording::head_bytes).substr(0, recording::head_bytes);
    if (head.empty())
        return failure("the file is empty", path_, "Nothing was recorded; record again");
    if (!recording::magic.starts_with(head.substr(0, recording::magic.size())))
        return failure("byte 0 does not begin a recording", path_,
                       "Give a .usarrec file; a text form becomes one with usar-mission text-to-recording");
    if (head.size() < recording::head_bytes)
        return failure("it ends at byte " + std::to_string(head.size()) + ", before anything was recorded", path_,
                       "Record again");
    const std::uint32_t version = recording::versionIn(head);
    if (version != recording::plain_version && version != recording::packed_version)
        return failure("byte 8 says a version of recordings that this program does not know", path_,
                       "Open it with a newer program");
    source_ = version == recording::plain_version ? plainSource(file_) : packedSource(file_);
    return {};
}

void RecordingReader::judgeEnd() {
    survey_.being_written = survey_.being_written && !survey_.ended;
    if (!survey_.damage.empty() && survey_.damage.back().offset + survey_.damage.back().bytes == file_.size()) {
        survey_.ended = false;
        if (survey_.being_written)
            survey_.damage.pop_back(); // The rest of that record is still being written.
        else
            survey_.tail_lost_bytes = survey_.damage.back().bytes;
    }
}

std::optional<Record> RecordingReader::next() {
    met_.clear();
    const auto record = source_->next(&met_);
    for (const RecordingDamage& piece : met_)
        addDamage(piece);
    return record;
}

void RecordingReader::addDamage(const RecordingDamage& piece) {
    const bool on_its_way = survey_.being_written && piece.offset + piece.bytes == file_.size();
    const auto after = std::ranges::lower_bound(survey_.damage, piece.offset, {}, &RecordingDamage::offset);
    const bool known = after != survey_.damage.end() && after->offset == piece.offset;
    if (!on_its_way && !known)
        survey_.damage.insert(after, piece);
}

} // namespace usar::link
