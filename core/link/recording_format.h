// The records and blocks of recordings, and their bytes exactly as resources/docs/recording-format.md specifies them.
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
inline constexpr std::uint32_t plain_version = 1;    ///< one record behind the other; older programs wrote it
inline constexpr std::uint32_t packed_version = 2;   ///< blocks of compressed records
inline constexpr std::size_t head_bytes = 12;        ///< magic and version
inline constexpr std::size_t record_head_bytes = 25; ///< before a plain record's payload
inline constexpr std::size_t block_head_bytes = 9;   ///< before a block's body
/// Largest payload of one record. A longer one is damage.
inline constexpr std::size_t longest_payload_bytes = 1u << 20;
/// Largest body of a block. A longer one is damage.
inline constexpr std::size_t longest_block_bytes = 4u << 20;

/// Appends the head of a file: magic and version.
void appendHead(std::string& file, std::uint32_t version = packed_version);
/// Version that a head of `head_bytes` names.
std::uint32_t versionIn(std::string_view head);

/// True for the kinds that have a name and a trigger.
bool hasLabel(RecordKind kind);

/// CutOff: the bytes end before the record or block does.
enum class Fit { Whole, CutOff, Damaged };

struct Taken {
    Fit fit = Fit::Damaged;
    Record record;        ///< with views into the bytes that `take` was given
    std::size_t size = 0; ///< size of a whole record in the file, in bytes; else 0
};

/// Reads the plain record at the beginning of `bytes`. CutOff: the record may be whole once there are more bytes.
Taken take(std::string_view bytes);
/// Size of the plain record at the beginning of `bytes`, judged by its head alone, without the checksum. Nullopt if no
/// record can begin here or there are fewer bytes than a head.
std::optional<std::size_t> sizeAt(std::string_view bytes);

/// Blocks of a packed file. First and Next hold records (recording_packing.h); those of a group, a First and the Nexts
/// behind it, are compressed in one go.
enum class BlockKind : std::uint8_t { First = 1, Next = 2, Index = 3 };

struct Block {
    Fit fit = Fit::Damaged;
    BlockKind kind = BlockKind::First;
    std::string_view body; ///< within the bytes that `takeBlock` was given
    std::size_t size = 0;  ///< A whole block takes so many bytes of the file; else it is 0.
};

void appendBlock(std::string& file, BlockKind kind, std::string_view body);
/// As `take` and `sizeAt`, for blocks.
Block takeBlock(std::string_view bytes);
std::optional<std::size_t> blockSizeAt(std::string_view bytes);

/// The end of an index: where in the file its block begins, so that it is found from the end of the file.
inline constexpr std::size_t index_end_bytes = 8;
void appendIndexEnd(std::string& body, std::uint64_t block_offset);
std::uint64_t indexEndIn(std::string_view last_bytes);

/// CRC-32 as used by zlib, PNG and Ethernet.
std::uint32_t checksum(std::string_view bytes);

} // namespace recording
} // namespace usar::link
