// A recording's records as bytes: what resources/docs/recording-format.md says, and nothing else.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/cause.h"

namespace usar::link {

/// Since the recording began, by a clock that never jumps.
using RecordTime = std::chrono::nanoseconds;

/// The numbers are those in the file. Readers keep kinds that they do not know.
enum class RecordKind : std::uint8_t {
    Start = 1,  ///< bytes: facts, "key: value" a line
    Opened = 2, ///< bytes: "host:port"
    Closed = 3, ///< bytes: why, in words
    In = 4,     ///< bytes from the server, as they arrived
    Out = 5,    ///< bytes to the server; name and trigger: their cause
    Note = 6,   ///< bytes: a text of the program's own, name: its topic, trigger: the line that it speaks of
    End = 7     ///< the recording was ended in order
};

/// One record; the texts are views into somebody else's bytes. `line` is the number of the newest info line that had
/// been read when the record was made: lines that an In record completes have the numbers after it.
struct Record {
    RecordKind kind = RecordKind::Note;
    RecordTime time{0};
    LineNumber line{};
    LineNumber trigger{};    ///< of Out and Note only
    std::string_view name{}; ///< of Out and Note only, 65535 bytes at most
    std::string_view bytes{};
    bool operator==(const Record&) const = default;
};

namespace recording {

inline constexpr std::string_view magic{"\x89USAR\r\n\x1a", 8};
inline constexpr std::uint32_t version = 1;
inline constexpr std::size_t head_bytes = 12;        ///< magic and version
inline constexpr std::size_t record_head_bytes = 25; ///< before a record's payload
/// Of a payload. Longer ones are damage.
inline constexpr std::size_t longest_payload_bytes = 1u << 20;

void appendHead(std::string& file);
/// Bytes beyond what one record holds go into further records of the same kind.
void append(std::string& file, const Record& record);

enum class Fit { Whole, CutOff, Damaged };

struct Taken {
    Fit fit = Fit::Damaged;
    Record record;
    std::size_t size = 0; ///< of a whole record, in bytes of the file
};

/// The record that `bytes` begin with. CutOff: it may be whole once there are more bytes.
Taken take(std::string_view bytes);
/// Its kind and size only, the checksum not looked at: whether a record could begin here at all, and how long it is.
std::optional<std::size_t> sizeAt(std::string_view bytes);

/// CRC-32 as zlib, PNG and Ethernet have it.
std::uint32_t checksum(std::string_view bytes);

} // namespace recording
} // namespace usar::link
