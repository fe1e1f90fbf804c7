#include "core/link/recording_packing.h"

#include <algorithm>

#include <zstd.h>

namespace usar::link {

namespace {

using recording::BlockKind;

/// A group that was full sooner than this is followed by one that is compressed fast.
constexpr std::chrono::seconds hasty{2};
constexpr int fast_level = 1;
constexpr int window_log = 18; ///< a group; more would only cost memory
/// The thorough way: what zstd's levels from 16 on do, with tables for a group, and with a search that takes a third of
/// the time for four percent more bytes.
constexpr std::pair<ZSTD_cParameter, int> thorough[] = {{ZSTD_c_strategy, ZSTD_btopt}, {ZSTD_c_hashLog, 17},
                                                        {ZSTD_c_chainLog, 18},         {ZSTD_c_searchLog, 2},
                                                        {ZSTD_c_minMatch, 4},          {ZSTD_c_targetLength, 16}};
/// Most bytes of the records in a block: a group, and the longest record behind it.
constexpr std::size_t most_unpacked_bytes =
    RecordPacker::group_bytes + recording::longest_payload_bytes + (64u << 10) + 64;

std::uint64_t difference(std::uint64_t now, std::uint64_t before) {
    return zigzag(static_cast<std::int64_t>(now - before));
}

std::uint64_t sum(std::uint64_t before, std::uint64_t coded) {
    return before + static_cast<std::uint64_t>(unzigzag(coded));
}

} // namespace

void RecordPacker::add(const Record& record) {
    Record piece = record;
    std::string_view rest = record.bytes;
    do {
        piece.bytes = rest.substr(0, recording::longest_payload_bytes);
        rest.remove_prefix(piece.bytes.size());
        addOne(piece);
    } while (!rest.empty());
}

void RecordPacker::addOne(const Record& record) {
    std::string& bytes = batch_.bytes;
    if (group_ >= group_bytes) {
        batch_.groups.push_back(bytes.size());
        before_ = {};
        group_ = 0;
    }
    const std::size_t begin = bytes.size();
    const auto time_ns = static_cast<std::uint64_t>(record.time.count());
    bytes += static_cast<char>(record.kind);
    appendVarint(bytes, time_ns - before_.time_ns);
    appendVarint(bytes, difference(record.line.value, before_.line));
    if (recording::hasLabel(record.kind)) {
        const std::string_view name = record.name.substr(0, 0xFFFF);
        appendVarint(bytes, difference(record.line.value, record.trigger.value));
        appendVarint(bytes, name.size());
        bytes += name;
    }
    appendVarint(bytes, record.bytes.size());
    bytes += record.bytes;
    before_ = {time_ns, record.line.value};
    group_ += bytes.size() - begin;
}

Record takePacked(ByteReader& bytes, PackedBefore& before) {
    Record record;
    record.kind = static_cast<RecordKind>(bytes.byte());
    before.time_ns += bytes.varint();
    before.line = sum(before.line, bytes.varint());
    record.time = RecordTime(static_cast<std::int64_t>(before.time_ns & INT64_MAX));
    record.line = {before.line};
    if (recording::hasLabel(record.kind)) {
        record.trigger = {before.line - static_cast<std::uint64_t>(unzigzag(bytes.varint()))};
        record.name = bytes.text(bytes.varint());
    }
    record.bytes = bytes.text(bytes.varint());
    return record;
}

void BlockWriter::Free::operator()(ZSTD_CCtx_s* context) const {
    ZSTD_freeCCtx(context);
}

BlockWriter::BlockWriter(std::uint64_t offset) : context_(ZSTD_createCCtx()), offset_(offset) {}

BlockWriter::~BlockWriter() = default;

void BlockWriter::append(std::string& file, PackedBatch batch) {
    const std::string_view all = batch.bytes;
    std::vector<std::size_t> cuts = std::move(batch.groups);
    const bool continues = cuts.empty() || cuts.front() > 0;
    if (continues)
        cuts.insert(cuts.begin(), 0);
    cuts.push_back(all.size());
    std::string body;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const std::string_view records = all.substr(cuts[i], cuts[i + 1] - cuts[i]);
        if (records.empty())
            continue;
        const bool first = i > 0 || !continues;
        body.clear();
        if (first) {
            beginGroup(offset_, records);
            body = state_;
        }
        compress(records, body);
        const std::size_t before = file.size();
        recording::appendBlock(file, first ? BlockKind::First : BlockKind::Next, body);
        offset_ += file.size() - before;
        for (ByteReader bytes(records); !bytes.empty();)
            counter_.take(takePacked(bytes, before_));
    }
}

void BlockWriter::beginGroup(std::uint64_t offset, std::string_view records) {
    const Clock::time_point now = Clock::now();
    const bool fast = !groups_.empty() && now - group_began_ < hasty;
    group_began_ = now;
    before_ = {};
    ByteReader bytes(records);
    PackedBefore before;
    const Record record = takePacked(bytes, before);
    groups_.push_back({offset, static_cast<std::uint64_t>(record.time.count())});
    std::string state;
    counter_.appendState(state);
    state_.clear();
    appendVarint(state_, groups_.back().time_ns);
    appendVarint(state_, state.size());
    state_ += state;
    if (!context_)
        return; // Nor is anything compressed then.
    ZSTD_CCtx_reset(context_.get(), ZSTD_reset_session_and_parameters);
    ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_compressionLevel, fast_level);
    ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_windowLog, window_log);
    if (!fast)
        for (const auto& [parameter, value] : thorough)
            ZSTD_CCtx_setParameter(context_.get(), parameter, value);
}

/// Flushes, so that all of it can be read. Without memory, the reader takes the group for damaged.
void BlockWriter::compress(std::string_view records, std::string& body) {
    if (!context_)
        return;
    ZSTD_inBuffer in{records.data(), records.size(), 0};
    for (std::size_t left = 1; left > 0;) {
        const std::size_t begin = body.size();
        body.resize(begin + ZSTD_compressBound(records.size()));
        ZSTD_outBuffer out{body.data() + begin, body.size() - begin, 0};
        left = ZSTD_compressStream2(context_.get(), &out, &in, ZSTD_e_flush);
        body.resize(begin + out.pos);
        if (ZSTD_isError(left))
            return; // Only without memory.
    }
}

void BlockWriter::appendIndex(std::string& file) {
    std::string body;
    counter_.appendWholeState(body);
    appendVarint(body, groups_.size());
    Group before;
    for (const Group& group : groups_) {
        appendVarint(body, group.offset - before.offset);
        appendVarint(body, group.time_ns - before.time_ns);
        before = group;
    }
    recording::appendIndexEnd(body, offset_);
    if (body.size() <= recording::longest_block_bytes)
        recording::appendBlock(file, BlockKind::Index, body);
}

void BlockReader::Free::operator()(ZSTD_DCtx_s* context) const {
    ZSTD_freeDCtx(context);
}

BlockReader::BlockReader() : context_(ZSTD_createDCtx()), room_(most_unpacked_bytes, '\0') {
    if (context_) // There is none without memory.
        ZSTD_DCtx_setParameter(context_.get(), ZSTD_d_windowLogMax, window_log);
}

BlockReader::~BlockReader() = default;

bool BlockReader::read(BlockKind kind, std::string_view compressed) {
    size_ = 0;
    if (!context_ || compressed.empty())
        return false;
    if (kind == BlockKind::First)
        ZSTD_DCtx_reset(context_.get(), ZSTD_reset_session_only);
    ZSTD_inBuffer in{compressed.data(), compressed.size(), 0};
    ZSTD_outBuffer out{room_.data(), room_.size(), 0};
    while (true) {
        const std::size_t before = in.pos + out.pos;
        if (ZSTD_isError(ZSTD_decompressStream(context_.get(), &out, &in)))
            break;
        if (in.pos == in.size && out.pos < out.size) {
            size_ = out.pos;
            return true;
        }
        if (in.pos + out.pos == before)
            break;
    }
    return false;
}

} // namespace usar::link
