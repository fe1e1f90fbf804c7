// Writes MCAP files (mcap.dev), the log format of Foxglove and ROS 2, from the first byte to the last without going
// back.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/id.h"
#include "core/mapping/byte_stream.h"

namespace usar::mission {

/// The shape of the messages on a channel: a JSON Schema with its name. Both texts must outlive the writer.
struct McapSchema {
    std::string_view name;
    std::string_view json;
};

using McapChannel = Id<struct McapChannelTag, std::uint16_t{0}>;

/// The times of a message, in nanoseconds of any one clock.
struct McapTimes {
    std::uint64_t logged_ns = 0;    ///< by which readers play the file
    std::uint64_t published_ns = 0; ///< of what the message says
};

/// Collects messages in JSON into uncompressed chunks with checksums and indexes. Once the sink has refused a piece,
/// nothing more is sent. Holds one chunk, and for each chunk that was sent 72 bytes and 16 for each of its channels. To
/// be used in one thread.
class McapWriter {
public:
    static constexpr std::size_t usual_chunk_bytes = std::size_t(1) << 20;

    /// Sends the head of the file. A chunk is sent as soon as it has `chunk_bytes`, so that it is longer by a part of a
    /// message.
    explicit McapWriter(mapping::ByteSink sink, std::size_t chunk_bytes = usual_chunk_bytes);

    /// Adds a channel, and its schema unless another channel has it already; its topic should be that of no other one.
    McapChannel addChannel(std::string_view topic, const McapSchema& schema);
    /// Adds a message of a channel that was added here.
    void write(McapChannel channel, const McapTimes& times, std::string_view json);
    /// Sends the rest, the summary and the foot. To be called once, as the last.
    void finish();

    /// True as long as the sink has taken everything.
    bool good() const { return good_; }
    std::uint64_t messageCount() const { return message_count_; }
    std::size_t channelCount() const { return channels_.size(); }
    /// Bytes sent, and those that wait in the chunk.
    std::uint64_t size() const { return sent_ + chunk_.size(); }

private:
    /// Least and greatest time at which the messages of something were logged; both 0 without messages.
    struct Span {
        std::uint64_t first_ns = 0;
        std::uint64_t last_ns = 0;
        void include(std::uint64_t time_ns, bool is_first);
    };
    struct Channel {
        std::string record; ///< its Channel record, which is repeated in the summary
        std::uint64_t messages = 0;
        std::vector<std::pair<std::uint64_t, std::uint64_t>> index{}; ///< time and offset of those in the chunk
    };
    struct Chunk {
        Span span;
        std::uint64_t offset = 0; ///< in the file, of the chunk
        std::uint64_t length = 0; ///< of its record
        std::uint64_t records = 0;
        std::uint64_t index_length = 0;                                 ///< of the message indexes behind it
        std::vector<std::pair<std::uint16_t, std::uint64_t>> indexes{}; ///< channel, and where in the file its index is
    };

    void send(const mapping::ByteBuffer& bytes);
    std::uint16_t schemaId(const McapSchema& schema);
    void sendChunk();
    void sendIndexes(Chunk& chunk);
    mapping::ByteBuffer summary(std::uint64_t begin) const;
    mapping::ByteBuffer statistics() const;
    static mapping::ByteBuffer indexOf(const Chunk& chunk);

    mapping::ByteSink sink_;
    std::size_t chunk_bytes_;
    mapping::ByteBuffer chunk_; ///< the records of the chunk that is not sent yet
    Span chunk_span_;
    std::uint64_t chunk_messages_ = 0;
    Span span_;
    std::uint64_t message_count_ = 0;
    std::uint64_t sent_ = 0;
    bool good_ = true;
    std::map<std::string_view, std::uint16_t> schema_ids_; ///< by name
    std::vector<std::string> schemas_;                     ///< their records; the id of the first is 1
    std::vector<Channel> channels_;                        ///< the id of the first is 1
    std::vector<Chunk> chunks_;
};

} // namespace usar::mission
