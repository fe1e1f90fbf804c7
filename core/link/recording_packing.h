// Packs records into the blocks of a recording, and unpacks them. resources/docs/recording-format.md specifies the
// bytes.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/byte_codec.h"
#include "core/link/recording_format.h"
#include "core/link/recording_survey.h"

struct ZSTD_CCtx_s;
struct ZSTD_DCtx_s;

namespace usar::link {

/// Time and line of the record before; each record in a group is written as its difference from them.
struct PackedBefore {
    std::uint64_t time_ns = 0;
    std::uint64_t line = 0;
};

/// Records on their way into blocks.
struct PackedBatch {
    std::string bytes;
    std::vector<std::size_t> groups; ///< offsets in `bytes` at which a group begins
};

/// Writes records one behind the other, and decides where a new group begins: with the first of all, and after 256 KiB.
class RecordPacker {
public:
    static constexpr std::size_t group_bytes = 256u << 10;

    /// Bytes beyond what one record holds go into further records of the same kind.
    void add(const Record& record);
    /// Bytes that wait to be taken.
    std::size_t size() const { return batch_.bytes.size(); }
    PackedBatch take() { return std::exchange(batch_, {}); }

private:
    void addOne(const Record& record);

    PackedBatch batch_;
    PackedBefore before_;
    std::size_t group_ = group_bytes; ///< bytes in the newest group
};

/// Reads the next record of a block; its texts are views into the reader's bytes. A malformed one sets bytes.failed().
Record takePacked(ByteReader& bytes, PackedBefore& before);

/// Compresses batches into blocks. A group that takes its time is compressed thoroughly, which costs a fifth of a
/// percent of a core at the rate of one robot; while records come much faster, a fast method keeps up with them.
class BlockWriter {
public:
    /// `offset`: size of the file so far.
    explicit BlockWriter(std::uint64_t offset);
    ~BlockWriter();

    /// Appends the blocks of a batch, one for each group in it. What it appends is decompressible as soon as it is in
    /// the file.
    void append(std::string& file, PackedBatch batch);
    /// Appends the index; nothing may follow. An index that is too long for a block is left out.
    void appendIndex(std::string& file);

private:
    using Clock = std::chrono::steady_clock;
    /// A group: where it begins, and the time of its first record.
    struct Group {
        std::uint64_t offset = 0;
        std::uint64_t time_ns = 0;
    };
    void beginGroup(std::uint64_t offset, std::string_view records);
    void compress(std::string_view records, std::string& body);

    struct Free {
        void operator()(ZSTD_CCtx_s* context) const;
    };
    std::unique_ptr<ZSTD_CCtx_s, Free> context_;
    std::uint64_t offset_;
    RecordCounter counter_;
    PackedBefore before_;
    std::vector<Group> groups_;
    Clock::time_point group_began_;
    std::string state_; ///< with which the newest group begins
};

/// Decompresses the blocks of one group after another.
class BlockReader {
public:
    BlockReader();
    ~BlockReader();

    /// The records of a block; for a First, `compressed` is what follows the state. Valid until the next call. False if
    /// the bytes are malformed or none, or there are more records than a block can have; the rest of the group is then
    /// lost.
    bool read(recording::BlockKind kind, std::string_view compressed);
    std::string_view records() const { return std::string_view(room_).substr(0, size_); }

private:
    struct Free {
        void operator()(ZSTD_DCtx_s* context) const;
    };
    std::unique_ptr<ZSTD_DCtx_s, Free> context_;
    std::string room_; ///< Its size stays: to fill it anew for each block would take longer than to read the block.
    std::size_t size_ = 0;
};

} // namespace usar::link
