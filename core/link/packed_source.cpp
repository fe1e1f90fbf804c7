#include <algorithm>

#include "core/link/recording_packing.h"
#include "core/link/recording_source.h"

namespace usar::link {

namespace {

using recording::Block;
using recording::BlockKind;
using recording::Fit;

/// The whole block at the beginning of these bytes begins a group or is the index.
bool beginsAnew(std::string_view bytes) {
    const Block block = recording::takeBlock(bytes);
    return block.fit == Fit::Whole && block.kind != BlockKind::Next;
}

/// Is surveyed by its index. Without one, from what each group says of those before it, so that only the last group is
/// unpacked. Only where something is damaged is all of it.
class PackedSource : public RecordSource {
public:
    explicit PackedSource(RecordingFile& file) : RecordSource(file) {}
    RecordingSurvey survey(bool thoroughly) override;
    std::optional<Record> next(std::vector<RecordingDamage>* damage) override;
    void seek(RecordTime time) override;
    void rest() override;
    std::uint64_t offset() const override { return block_offset_; }

private:
    void goTo(const Entry& entry) override;
    void index(const Record& record) override {
        if (index_.empty() || index_.back().offset != group_offset_)
            index_.push_back({record.time, group_offset_});
    }
    /// Takes counts and groups from the index at the end of the file; false if there is none.
    bool readIndex(RecordCounter& counter);
    /// The same from the groups; false if something other than the end of the file is damaged.
    bool scan(RecordCounter& counter, std::vector<RecordingDamage>& damage);
    /// The facts and the first line, which only the first record tells.
    void readFirst(RecordingSurvey& survey);
    /// Whether all blocks are whole.
    bool allWhole();
    Block blockAt(std::uint64_t offset);
    /// Goes on to the next block that holds records; false at the end of the file.
    bool load(std::vector<RecordingDamage>* damage);
    /// Makes the records of the block at `position_` the next ones.
    bool unpack(const Block& block);
    /// Passes over what is damaged from `offset` on.
    void skip(std::uint64_t offset, std::vector<RecordingDamage>* damage);

    std::optional<BlockReader> unpacker_ = std::nullopt; ///< made when it is needed
    std::uint64_t position_ = recording::head_bytes;     ///< The block here is read next.
    std::uint64_t block_offset_ = 0;                     ///< `bytes_` reads the block here.
    std::uint64_t group_offset_ = 0;                     ///< Its group begins here.
    std::size_t group_bytes_ = 0;                        ///< So many bytes of its group are unpacked.
    ByteReader bytes_{{}};
    PackedBefore before_;
};

void PackedSource::goTo(const Entry& entry) {
    position_ = entry.offset;
    newest_ = entry.time;
    bytes_ = ByteReader({});
}

void PackedSource::rest() {
    RecordSource::rest();
    bytes_ = ByteReader({}); // They are the unpacker's.
    unpacker_.reset();
}

Block PackedSource::blockAt(std::uint64_t offset) {
    std::string_view bytes = file_.at(offset, recording::block_head_bytes);
    if (const auto size = recording::blockSizeAt(bytes))
        bytes = file_.at(offset, *size);
    return recording::takeBlock(bytes);
}

RecordingSurvey PackedSource::survey(bool thoroughly) {
    RecordCounter counter;
    std::vector<RecordingDamage> damage;
    if (!(readIndex(counter) && (!thoroughly || allWhole()))) {
        counter = {};
        index_.clear();
        if (!scan(counter, damage)) {
            index_.clear();
            return surveyByReading();
        }
    }
    RecordingSurvey survey = counter.survey();
    survey.damage = std::move(damage);
    if (!index_.empty())
        readFirst(survey);
    return survey;
}

bool PackedSource::readIndex(RecordCounter& counter) {
    constexpr std::size_t end_bytes = recording::index_end_bytes;
    if (file_.size() < recording::head_bytes + recording::block_head_bytes + end_bytes)
        return false;
    const std::string_view end = file_.at(file_.size() - end_bytes, end_bytes);
    if (end.size() < end_bytes)
        return false; // The file was cut since it was measured.
    const std::uint64_t offset = recording::indexEndIn(end);
    if (offset < recording::head_bytes || offset >= file_.size())
        return false;
    const Block block = blockAt(offset);
    if (block.fit != Fit::Whole || block.kind != BlockKind::Index || offset + block.size != file_.size())
        return false;
    ByteReader bytes(block.body);
    if (!counter.continueFrom(bytes))
        return false;
    Entry entry;
    std::uint64_t time_ns = 0;
    for (std::uint64_t left = bytes.varint(); left > 0 && !bytes.failed(); --left) {
        entry.offset += bytes.varint();
        time_ns += bytes.varint(); // Modulo 2^64: in a text that became a recording, times may run backward.
        entry.time = std::max(entry.time, RecordTime(static_cast<std::int64_t>(time_ns & INT64_MAX)));
        index_.push_back(entry);
    }
    return !bytes.failed() && !index_.empty();
}

bool PackedSource::allWhole() {
    for (std::uint64_t offset = recording::head_bytes; offset < file_.size();) {
        const Block block = blockAt(offset);
        if (block.fit != Fit::Whole)
            return false;
        offset += block.size;
    }
    return true;
}

bool PackedSource::scan(RecordCounter& counter, std::vector<RecordingDamage>& damage) {
    for (std::uint64_t offset = recording::head_bytes; offset < file_.size();) {
        const Block block = blockAt(offset);
        if (block.fit != Fit::Whole)
            break; // Reading the last group tells whether anything follows.
        if (block.kind == BlockKind::First) {
            ByteReader bytes(block.body);
            const auto time = RecordTime(static_cast<std::int64_t>(bytes.varint() & INT64_MAX));
            ByteReader state(bytes.text(bytes.varint()));
            if (!counter.continueFrom(state))
                return false;
            index_.push_back({std::max(time, index_.empty() ? time : index_.back().time), offset});
        }
        offset += block.size;
    }
    if (index_.empty())
        return false;
    goTo(index_.back());
    while (const auto record = next(&damage))
        counter.take(*record);
    return damage.empty() || (damage.size() == 1 && damage[0].offset + damage[0].bytes == file_.size());
}

void PackedSource::readFirst(RecordingSurvey& survey) {
    goTo(index_.front());
    const auto record = next(nullptr);
    if (!record)
        return;
    RecordCounter first;
    first.take(*record);
    survey.first_line = first.survey().first_line;
    survey.facts = first.survey().facts;
}

std::optional<Record> PackedSource::next(std::vector<RecordingDamage>* damage) {
    while (!bytes_.empty() || load(damage)) {
        Record record = takePacked(bytes_, before_);
        if (!bytes_.failed() && record.kind != RecordKind{}) {
            newest_ = record.time = std::max(newest_, record.time);
            return record;
        }
        skip(block_offset_, damage);
    }
    return std::nullopt;
}

bool PackedSource::load(std::vector<RecordingDamage>* damage) {
    while (position_ < file_.size()) {
        const Block block = blockAt(position_);
        const bool whole = block.fit == Fit::Whole;
        if (whole && block.kind == BlockKind::Index) {
            position_ += block.size;
            continue;
        }
        if (!whole || !unpack(block)) {
            skip(position_, damage);
            continue;
        }
        block_offset_ = position_;
        position_ += block.size;
        return true;
    }
    return false;
}

bool PackedSource::unpack(const Block& block) {
    ByteReader body(block.body);
    if (block.kind == BlockKind::First) {
        body.varint();            // The time of the first record.
        body.text(body.varint()); // The state of what comes before.
        before_ = {};
        group_offset_ = position_;
        group_bytes_ = 0;
    }
    const std::string_view compressed = body.rest();
    const bool goes_on = group_bytes_ < RecordPacker::group_bytes; // Behind that, writers begin another group.
    if (!unpacker_)
        unpacker_.emplace();
    if (body.failed() || !goes_on || !unpacker_->read(block.kind, compressed))
        return false;
    bytes_ = ByteReader(unpacker_->records());
    group_bytes_ += unpacker_->records().size();
    return true;
}

void PackedSource::skip(std::uint64_t offset, std::vector<RecordingDamage>* damage) {
    const std::uint64_t good =
        search(offset + 1, recording::block_head_bytes, recording::blockSizeAt, beginsAnew).value_or(file_.size());
    if (damage)
        damage->push_back({offset, good - offset});
    position_ = good;
    bytes_ = ByteReader({});
}

void PackedSource::seek(RecordTime time) {
    goTo(entryBefore(time));
    while (true) {
        if (bytes_.empty() && !load(nullptr))
            return;
        const ByteReader bytes = bytes_;
        const PackedBefore before = before_;
        const std::uint64_t block = block_offset_;
        const auto record = next(nullptr);
        if (!record)
            return;
        if (record->time < time)
            continue;
        const bool same = block == block_offset_; // Else it is the first one behind damage.
        bytes_ = same ? bytes : ByteReader(unpacker_->records());
        before_ = same ? before : PackedBefore{};
        return;
    }
}

} // namespace

std::unique_ptr<RecordSource> packedSource(RecordingFile& file) {
    return std::make_unique<PackedSource>(file);
}

} // namespace usar::link
