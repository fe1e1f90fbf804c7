#include "core/link/recording_reader.h"

#include <algorithm>
#include <utility>

namespace usar::link {

Result<std::unique_ptr<RecordingReader>> RecordingReader::open(const QString& path, OpenMode mode) {
    auto chain = openRecordingChain(path, mode);
    if (!chain)
        return tl::unexpected(chain.error());
    return std::unique_ptr<RecordingReader>(new RecordingReader(*std::move(chain), path.toStdString()));
}

RecordingReader::RecordingReader(RecordingChain chain, std::string path)
    : path_(std::move(path))
    , parts_(std::move(chain.parts)) {
    for (RecordingPart& part : parts_) {
        part.begin = std::min(survey_.span, PlayClock::longest);
        part.begin_bytes = survey_.file_bytes;
        if (&part == &parts_.front())
            survey_ = std::move(part.survey);
        else
            survey_.append(part.survey);
        survey_.files.push_back({part.name, part.begin_bytes});
    }
    survey_.parts_lost = partNumberOf(survey_) - 1;
    survey_.why_lost = std::move(chain.broken);
    survey_.later = std::move(chain.later);
    survey_.not_read = std::move(chain.not_read);
    survey_.being_written = survey_.being_written || chain.newest_begins;
    seek(RecordTime{0});
}

void RecordingReader::goTo(std::size_t part) {
    if (part != now_)
        parts_[now_].source->rest();
    now_ = part;
}

void RecordingReader::seek(RecordTime time) {
    const auto after = std::find_if(parts_.begin() + 1, parts_.end(),
                                    [time](const RecordingPart& part) { return part.begin >= time; });
    goTo(static_cast<std::size_t>(after - parts_.begin()) - 1);
    parts_[now_].source->seek(time - parts_[now_].begin);
}

std::optional<Record> RecordingReader::next() {
    while (true) {
        met_.clear();
        const RecordingPart& part = parts_[now_];
        auto record = part.source->next(&met_);
        for (const RecordingDamage& piece : met_)
            addDamage({part.begin_bytes + piece.offset, piece.bytes});
        if (record && now_ > 0)
            record->time = part.begin + std::min(record->time, PlayClock::longest);
        if (record || now_ + 1 == parts_.size())
            return record;
        goTo(now_ + 1);
        parts_[now_].source->seek(RecordTime{0});
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
