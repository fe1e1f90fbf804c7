#include "core/link/recording_source.h"

#include <algorithm>
#include <cerrno>

#include <sys/file.h>

namespace usar::link {

namespace {

constexpr std::size_t window_bytes = 2u << 20;
constexpr std::uint64_t index_step_bytes = 64u << 10;

class PlainSource : public RecordSource {
public:
    explicit PlainSource(RecordingFile& file) : RecordSource(file) {}
    RecordingSurvey survey(bool) override { return surveyByReading(); }
    std::optional<Record> next(std::vector<RecordingDamage>* damage) override;
    void seek(RecordTime time) override;
    std::uint64_t offset() const override { return record_offset_; }

private:
    void index(const Record& record) override {
        if (index_.empty() || record_offset_ - index_.back().offset >= index_step_bytes)
            index_.push_back({record.time, record_offset_});
    }
    void goTo(const Entry& entry) override {
        position_ = entry.offset;
        newest_ = entry.time;
    }

    std::uint64_t position_ = recording::head_bytes;
    std::uint64_t record_offset_ = 0;
};

std::optional<Record> PlainSource::next(std::vector<RecordingDamage>* damage) {
    while (position_ < file_.size()) {
        std::string_view bytes = file_.at(position_, recording::record_head_bytes);
        if (const auto size = recording::sizeAt(bytes))
            bytes = file_.at(position_, *size);
        recording::Taken taken = recording::take(bytes);
        if (taken.fit == recording::Fit::Whole) {
            record_offset_ = position_;
            position_ += taken.size;
            newest_ = taken.record.time = std::max(newest_, taken.record.time);
            return taken.record;
        }
        const auto whole = [](std::string_view found) { return recording::take(found).fit == recording::Fit::Whole; };
        const std::uint64_t good =
            search(position_ + 1, recording::record_head_bytes, recording::sizeAt, whole).value_or(file_.size());
        if (damage)
            damage->push_back({position_, good - position_});
        position_ = good;
    }
    return std::nullopt;
}

void PlainSource::seek(RecordTime time) {
    goTo(entryBefore(time));
    while (position_ < file_.size()) {
        const auto record = next(nullptr);
        if (record && record->time < time)
            continue;
        position_ = record ? record_offset_ : file_.size();
        return;
    }
}

} // namespace

bool RecordingFile::open(const QString& path) {
    file_.setFileName(path);
    return file_.open(QIODevice::ReadOnly | QIODevice::Unbuffered);
}

/// A writer holds a lock on its file for as long as it runs.
bool RecordingFile::writerLives() {
    if (::flock(file_.handle(), LOCK_SH | LOCK_NB) == 0) {
        ::flock(file_.handle(), LOCK_UN);
        return false;
    }
    return errno == EWOULDBLOCK;
}

void RecordingFile::measure() {
    size_ = static_cast<std::uint64_t>(std::max<qint64>(file_.size(), 0));
}

std::string_view RecordingFile::at(std::uint64_t offset, std::size_t least) {
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

RecordingSurvey RecordSource::surveyByReading() {
    RecordCounter counter;
    std::vector<RecordingDamage> damage;
    goTo({{}, recording::head_bytes});
    while (const auto record = next(&damage)) {
        index(*record);
        counter.take(*record);
    }
    RecordingSurvey survey = counter.survey();
    survey.damage = std::move(damage);
    return survey;
}

RecordSource::Entry RecordSource::entryBefore(RecordTime time) const {
    const auto after = std::ranges::lower_bound(index_, time, {}, &Entry::time);
    return after == index_.begin() ? Entry{{}, recording::head_bytes} : *std::prev(after);
}

std::unique_ptr<RecordSource> plainSource(RecordingFile& file) {
    return std::make_unique<PlainSource>(file);
}

} // namespace usar::link
