// Files as earlier versions of this program recorded them: version 1, one plain record behind the other.
#pragma once

#include <string>

#include "core/link/recording_format.h"

namespace usar::doubles {

template <class Unsigned>
void appendNumber(std::string& out, Unsigned value) {
    for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
        out += static_cast<char>((value >> (8 * i)) & 0xFFu);
}

inline void appendOldHead(std::string& file) {
    link::recording::appendHead(file, link::recording::plain_version);
}

inline void appendOnePlain(std::string& file, const link::Record& record) {
    constexpr std::size_t checksum_at = 4, kind_at = 8;
    const std::size_t begin = file.size();
    const std::size_t label_bytes = link::recording::hasLabel(record.kind) ? 10 + record.name.size() : 0;
    appendNumber(file, static_cast<std::uint32_t>(label_bytes + record.bytes.size()));
    appendNumber(file, std::uint32_t{0}); // The checksum takes its place below.
    file += static_cast<char>(record.kind);
    appendNumber(file, static_cast<std::uint64_t>(record.time.count()));
    appendNumber(file, record.line.value);
    if (label_bytes > 0) {
        appendNumber(file, record.trigger.value);
        appendNumber(file, static_cast<std::uint16_t>(record.name.size()));
        file += record.name;
    }
    file += record.bytes;
    std::string sum;
    appendNumber(sum, link::recording::checksum(std::string_view(file).substr(begin + kind_at)));
    file.replace(begin + checksum_at, sum.size(), sum);
}

/// Bytes beyond what one record holds go into further records of the same kind.
inline void appendPlain(std::string& file, const link::Record& record) {
    const std::size_t label_bytes = link::recording::hasLabel(record.kind) ? 10 + record.name.size() : 0;
    link::Record piece = record;
    std::string_view rest = record.bytes;
    do {
        piece.bytes = rest.substr(0, link::recording::longest_payload_bytes - label_bytes);
        rest.remove_prefix(piece.bytes.size());
        appendOnePlain(file, piece);
    } while (!rest.empty());
}

} // namespace usar::doubles
