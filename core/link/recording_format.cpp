#include "core/link/recording_format.h"

#include <zlib.h>

namespace usar::link::recording {

namespace {

// Offsets in a record. The checksum covers everything after it.
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

bool hasLabel(RecordKind kind) {
    return kind == RecordKind::Out || kind == RecordKind::Note;
}

void appendOne(std::string& file, const Record& record) {
    const std::size_t begin = file.size();
    const bool labelled = hasLabel(record.kind);
    const std::string_view name = record.name.substr(0, 0xFFFF);
    const std::size_t label_bytes = labelled ? label_head_bytes + name.size() : 0;
    appendNumber(file, static_cast<std::uint32_t>(label_bytes + record.bytes.size()));
    appendNumber(file, std::uint32_t{0}); // Placeholder for the checksum, which is filled in below.
    file += static_cast<char>(record.kind);
    appendNumber(file, static_cast<std::uint64_t>(record.time.count()));
    appendNumber(file, record.line.value);
    if (labelled) {
        appendNumber(file, record.trigger.value);
        appendNumber(file, static_cast<std::uint16_t>(name.size()));
        file += name;
    }
    file += record.bytes;
    std::string sum;
    appendNumber(sum, checksum(std::string_view(file).substr(begin + kind_at)));
    file.replace(begin + checksum_at, sum.size(), sum);
}

} // namespace

std::uint32_t checksum(std::string_view bytes) {
    return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

void appendHead(std::string& file) {
    file += magic;
    appendNumber(file, version);
}

void append(std::string& file, const Record& record) {
    const std::size_t label_bytes = hasLabel(record.kind) ? label_head_bytes + record.name.substr(0, 0xFFFF).size() : 0;
    const std::size_t most = longest_payload_bytes - label_bytes;
    Record piece = record;
    std::string_view rest = record.bytes;
    do {
        piece.bytes = rest.substr(0, most);
        rest.remove_prefix(piece.bytes.size());
        appendOne(file, piece);
    } while (!rest.empty());
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

} // namespace usar::link::recording
