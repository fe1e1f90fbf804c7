// The records of a recording as bytes, exactly as resources/docs/recording-format.md specifies them.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/cause.h"

namespace usar::link {

/// Time since the recording began, by a steady clock.
using RecordTime = std::chrono::nanoseconds;

/// The values are those in the file. Readers keep kinds that they do not know.
enum class RecordKind : std::uint8_t {
    Start = 1,  ///< bytes: facts, one "key: value" per line
    Opened = 2, ///< bytes: "host:port"
    Closed = 3, ///< bytes: the reason, in words
    In = 4,     ///< bytes: received from the server, as they arrived
    Out = 5,    ///< bytes: sent to the server; name and trigger: their cause
    Note = 6,   ///< bytes: a text of this program; name: its topic; trigger: the line to which it refers
    End = 7     ///< the recording was ended properly
};

/// One record. Its texts are views into bytes that belong to someone else. `line` is the number of the newest info line
/// that had been read when the record was made: lines that an In record completes have the numbers after it.
struct Record {
    RecordKind kind = RecordKind::Note;
    RecordTime time{0};
    LineNumber line{};
    LineNumber trigger{};    ///< only for Out and Note
    std::string_view name{}; ///< only for Out and Note; at most 65535 bytes
    std::string_view bytes{};
    bool operator==(const Record&) const = default;
};

namespace recording {

inline constexpr std::string_view magic{"\x89USAR\r\n\x1a", 8};
inline constexpr std::uint32_t version = 1;
inline constexpr std::size_t head_bytes = 12;        ///< magic and version
inline constexpr std::size_t record_head_bytes = 25; ///< before a record's payload
/// Largest payload of one record. A longer one is damage.
inline constexpr std::size_t longest_payload_bytes = 1u << 20;

/// Appends the head of a file: magic and version.
void appendHead(std::string& file);
/// Appends the record. Bytes beyond what one record holds go into further records of the same kind.
void append(std::string& file, const Record& record);

/// CutOff: the bytes end before the record does.
enum class Fit { Whole, CutOff, Damaged };

struct Taken {
    Fit fit = Fit::Damaged;
    Record record;        ///< with views into the bytes that `take` was given
    std::size_t size = 0; ///< size of a whole record in the file, in bytes; else 0
};

/// Reads the record at the beginning of `bytes`. CutOff: the record may be whole once there are more bytes.
Taken take(std::string_view bytes);
/// Size of the record at the beginning of `bytes`, judged by its head alone, without the checksum. Nullopt if no record
/// can begin here or there are fewer bytes than a head.
std::optional<std::size_t> sizeAt(std::string_view bytes);

/// CRC-32 as used by zlib, PNG and Ethernet.
std::uint32_t checksum(std::string_view bytes);

} // namespace recording
} // namespace usar::link
