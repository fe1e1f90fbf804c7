#include "core/link/recording_format.h"

#include <zlib.h>

namespace usar::link::recording {

namespace {

// Offsets in a plain record, and the first two in a block. The checksum covers everything after it.
constexpr std::size_t checksum_at = 4;
constexpr std::size_t kind_at = 8;
constexpr std::size_t time_at = 9;
constexpr std::size_t line_at = 17;
// Head of the label with which the payload of Out and Note records begins.
constexpr std::size_t label_head_bytes = 10;

template <class Unsigned>
void appendNumber(std::string& out, Unsigned value) {
    for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
        out += static_cast<char>((value >> (8 * i)) & 0xFFu);
}

template <class Unsigned>
Unsigned numberAt(std::string_view bytes, std::size_t at) {
    Unsigned value = 0;
    for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
        value = static_cast<Unsigned>(
            value | (static_cast<Unsigned>(static_cast<unsigned char>(bytes[at + i])) << static_cast<unsigned>(8 * i)));
    return value;
}

} // namespace

std::uint32_t checksum(std::string_view bytes) {
    return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

void appendHead(std::string& file, std::uint32_t version) {
    file += magic;
    appendNumber(file, version);
}

std::uint32_t versionIn(std::string_view head) {
    return numberAt<std::uint32_t>(head, magic.size());
}

bool hasLabel(RecordKind kind) {
    return kind == RecordKind::Out || kind == RecordKind::Note;
}

std::optional<std::size_t> sizeAt(std::string_view bytes) {
    if (bytes.size() < record_head_bytes)
        return std::nullopt;
    const auto payload = numberAt<std::uint32_t>(bytes, 0);
    const auto kind = static_cast<RecordKind>(bytes[kind_at]);
    if (payload > longest_payload_bytes || kind == RecordKind{} || (hasLabel(kind) && payload < label_head_bytes))
        return std::nullopt;
    return record_head_bytes + payload;
}

Taken take(std::string_view bytes) {
    const auto size = sizeAt(bytes);
    if (bytes.size() < size.value_or(record_head_bytes))
        return {.fit = Fit::CutOff, .record = {}, .size = 0};
    if (!size)
        return {};
    bytes = bytes.substr(0, *size);
    if (numberAt<std::uint32_t>(bytes, checksum_at) != checksum(bytes.substr(kind_at)))
        return {};
    Taken taken{.fit = Fit::Whole, .record = {}, .size = *size};
    Record& record = taken.record;
    record.kind = static_cast<RecordKind>(bytes[kind_at]);
    record.time = RecordTime(static_cast<std::int64_t>(numberAt<std::uint64_t>(bytes, time_at)));
    record.line = {numberAt<std::uint64_t>(bytes, line_at)};
    record.bytes = bytes.substr(record_head_bytes);
    if (record.time < RecordTime::zero())
        return {};
    if (hasLabel(record.kind)) {
        const std::string_view payload = record.bytes;
        record.trigger = {numberAt<std::uint64_t>(payload, 0)};
        const std::size_t name_size = numberAt<std::uint16_t>(payload, 8);
        if (label_head_bytes + name_size > payload.size())
            return {};
        record.name = payload.substr(label_head_bytes, name_size);
        record.bytes = payload.substr(label_head_bytes + name_size);
    }
    return taken;
}

void appendBlock(std::string& file, BlockKind kind, std::string_view body) {
    const std::size_t begin = file.size();
    appendNumber(file, static_cast<std::uint32_t>(body.size()));
    appendNumber(file, std::uint32_t{0}); // The checksum takes its place below.
    file += static_cast<char>(kind);
    file += body;
    std::string sum;
    appendNumber(sum, checksum(std::string_view(file).substr(begin + kind_at)));
    file.replace(begin + checksum_at, sum.size(), sum);
}

std::optional<std::size_t> blockSizeAt(std::string_view bytes) {
    if (bytes.size() < block_head_bytes)
        return std::nullopt;
    const auto body = numberAt<std::uint32_t>(bytes, 0);
    const auto kind = static_cast<BlockKind>(bytes[kind_at]);
    if (body > longest_block_bytes || kind < BlockKind::First || kind > BlockKind::Index)
        return std::nullopt;
    return block_head_bytes + body;
}

Block takeBlock(std::string_view bytes) {
    const auto size = blockSizeAt(bytes);
    if (bytes.size() < size.value_or(block_head_bytes))
        return {Fit::CutOff, BlockKind::First, {}, 0};
    if (!size)
        return {};
    bytes = bytes.substr(0, *size);
    if (numberAt<std::uint32_t>(bytes, checksum_at) != checksum(bytes.substr(kind_at)))
        return {};
    return {Fit::Whole, static_cast<BlockKind>(bytes[kind_at]), bytes.substr(block_head_bytes), *size};
}

void appendIndexEnd(std::string& body, std::uint64_t block_offset) {
    appendNumber(body, block_offset);
}

std::uint64_t indexEndIn(std::string_view last_bytes) {
    return numberAt<std::uint64_t>(last_bytes, 0);
}

} // namespace usar::link::recording
