#include "core/mission/files/mcap_writer.h"

#include <algorithm>
#include <utility>

#include "core/base/version.h"
#include "core/link/recording_format.h"

namespace usar::mission {

namespace {

using mapping::ByteBuffer;

constexpr std::string_view magic{"\x89MCAP0\r\n", 8};

enum class Opcode : std::uint8_t {
    Header = 1,
    Footer = 2,
    Schema = 3,
    Channel = 4,
    Message = 5,
    Chunk = 6,
    MessageIndex = 7,
    ChunkIndex = 8,
    Statistics = 11,
    SummaryOffset = 14,
    DataEnd = 15
};

std::string_view view(const ByteBuffer& bytes) {
    return {bytes.bytes().data(), bytes.size()};
}

void addText(ByteBuffer& to, std::string_view text) {
    to.add(static_cast<std::uint32_t>(text.size()));
    to.add(text);
}

/// What stands before a record: its opcode, and how long its content is.
void addHead(ByteBuffer& to, Opcode opcode, std::uint64_t content_bytes) {
    to.add(static_cast<std::uint8_t>(opcode));
    to.add(content_bytes);
}

void addRecord(ByteBuffer& to, Opcode opcode, const ByteBuffer& content) {
    addHead(to, opcode, content.size());
    to.add(view(content));
}

std::string recordOf(Opcode opcode, const ByteBuffer& content) {
    ByteBuffer record;
    addRecord(record, opcode, content);
    return std::string(view(record));
}

/// The groups of records in a summary, which its end points to.
class Groups {
public:
    /// `begin`: offset of the summary in the file.
    explicit Groups(std::uint64_t begin) : begin_(begin) {}

    /// The records that `summary` has got since the last call are one group; without any there is none.
    void close(Opcode opcode, const ByteBuffer& summary) {
        if (summary.size() > closed_) {
            ByteBuffer content;
            content.add(static_cast<std::uint8_t>(opcode));
            content.add(begin_ + closed_);
            content.add(std::uint64_t(summary.size() - closed_));
            addRecord(offsets_, Opcode::SummaryOffset, content);
        }
        closed_ = summary.size();
    }
    const ByteBuffer& offsets() const { return offsets_; }

private:
    std::uint64_t begin_;
    std::uint64_t closed_ = 0;
    ByteBuffer offsets_;
};

} // namespace

void McapWriter::Span::include(std::uint64_t time_ns, bool is_first) {
    first_ns = is_first ? time_ns : std::min(first_ns, time_ns);
    last_ns = is_first ? time_ns : std::max(last_ns, time_ns);
}

McapWriter::McapWriter(mapping::ByteSink sink, std::size_t chunk_bytes)
    : sink_(std::move(sink))
    , chunk_bytes_(chunk_bytes) {
    ByteBuffer content;
    addText(content, ""); // The profile: none.
    addText(content, "USAR Mission Control " + std::string(version()));
    ByteBuffer head;
    head.add(magic);
    addRecord(head, Opcode::Header, content);
    send(head);
}

void McapWriter::send(const ByteBuffer& bytes) {
    good_ = good_ && sink_(bytes.bytes().data(), bytes.size());
    sent_ += bytes.size();
}

std::uint16_t McapWriter::schemaId(const McapSchema& schema) {
    const auto [known, is_new] = schema_ids_.try_emplace(schema.name, static_cast<std::uint16_t>(schemas_.size() + 1));
    if (is_new) {
        ByteBuffer content;
        content.add(known->second);
        addText(content, schema.name);
        addText(content, "jsonschema");
        addText(content, schema.json);
        schemas_.push_back(recordOf(Opcode::Schema, content));
        chunk_.add(std::string_view(schemas_.back()));
    }
    return known->second;
}

McapChannel McapWriter::addChannel(std::string_view topic, const McapSchema& schema) {
    const auto id = static_cast<std::uint16_t>(channels_.size() + 1);
    ByteBuffer content;
    content.add(id);
    content.add(schemaId(schema));
    addText(content, topic);
    addText(content, "json");
    addText(content, ""); // An empty map: nothing else is to be said of the channel.
    channels_.push_back({.record = recordOf(Opcode::Channel, content)});
    chunk_.add(std::string_view(channels_.back().record));
    return {id};
}

void McapWriter::write(McapChannel channel, const McapTimes& times, std::string_view json) {
    Channel& to = channels_[channel.index() - 1];
    to.index.emplace_back(times.logged_ns, chunk_.size());
    addHead(chunk_, Opcode::Message, 2 + 4 + 8 + 8 + json.size());
    chunk_.add(channel.value);
    chunk_.add(static_cast<std::uint32_t>(to.messages++));
    chunk_.add(times.logged_ns);
    chunk_.add(times.published_ns);
    chunk_.add(json);
    chunk_span_.include(times.logged_ns, chunk_messages_++ == 0);
    span_.include(times.logged_ns, message_count_++ == 0);
    if (chunk_.size() >= chunk_bytes_)
        sendChunk();
}

void McapWriter::sendChunk() {
    Chunk chunk{.span = chunk_span_, .offset = sent_, .records = chunk_.size()};
    ByteBuffer content;
    content.add(chunk.span.first_ns);
    content.add(chunk.span.last_ns);
    content.add(chunk.records);
    content.add(link::recording::checksum(view(chunk_)));
    addText(content, ""); // The compression: none.
    content.add(chunk.records);
    ByteBuffer head;
    addHead(head, Opcode::Chunk, content.size() + chunk.records);
    head.add(view(content));
    chunk.length = head.size() + chunk.records;
    send(head);
    send(chunk_);
    sendIndexes(chunk);
    chunks_.push_back(std::move(chunk));
    chunk_.clear();
    chunk_span_ = {};
    chunk_messages_ = 0;
}

void McapWriter::sendIndexes(Chunk& chunk) {
    const std::uint64_t begin = sent_;
    for (std::size_t place = 0; place < channels_.size(); ++place) {
        auto& index = channels_[place].index;
        if (index.empty())
            continue;
        const auto id = static_cast<std::uint16_t>(place + 1);
        ByteBuffer content;
        content.add(id);
        content.add(static_cast<std::uint32_t>(index.size() * 16));
        for (const auto& [time_ns, offset] : index) {
            content.add(time_ns);
            content.add(offset);
        }
        index.clear();
        chunk.indexes.emplace_back(id, sent_);
        ByteBuffer record;
        addRecord(record, Opcode::MessageIndex, content);
        send(record);
    }
    chunk.index_length = sent_ - begin;
}

ByteBuffer McapWriter::indexOf(const Chunk& chunk) {
    ByteBuffer content;
    content.add(chunk.span.first_ns);
    content.add(chunk.span.last_ns);
    content.add(chunk.offset);
    content.add(chunk.length);
    content.add(static_cast<std::uint32_t>(chunk.indexes.size() * 10));
    for (const auto& [id, offset] : chunk.indexes) {
        content.add(id);
        content.add(offset);
    }
    content.add(chunk.index_length);
    addText(content, "");
    content.add(chunk.records); // As stored, and uncompressed.
    content.add(chunk.records);
    return content;
}

ByteBuffer McapWriter::statistics() const {
    ByteBuffer content;
    content.add(message_count_);
    content.add(static_cast<std::uint16_t>(schemas_.size()));
    content.add(static_cast<std::uint32_t>(channels_.size()));
    content.add(std::uint32_t{0}); // Attachments.
    content.add(std::uint32_t{0}); // Metadata.
    content.add(static_cast<std::uint32_t>(chunks_.size()));
    content.add(span_.first_ns);
    content.add(span_.last_ns);
    content.add(static_cast<std::uint32_t>(channels_.size() * 10));
    for (std::size_t place = 0; place < channels_.size(); ++place) {
        content.add(static_cast<std::uint16_t>(place + 1));
        content.add(channels_[place].messages);
    }
    return content;
}

/// The summary, the offsets of its groups, and the foot up to its checksum, which counts all of them.
ByteBuffer McapWriter::summary(std::uint64_t begin) const {
    ByteBuffer summary;
    Groups groups(begin);
    for (const std::string& schema : schemas_)
        summary.add(std::string_view(schema));
    groups.close(Opcode::Schema, summary);
    for (const Channel& channel : channels_)
        summary.add(std::string_view(channel.record));
    groups.close(Opcode::Channel, summary);
    for (const Chunk& chunk : chunks_)
        addRecord(summary, Opcode::ChunkIndex, indexOf(chunk));
    groups.close(Opcode::ChunkIndex, summary);
    addRecord(summary, Opcode::Statistics, statistics());
    groups.close(Opcode::Statistics, summary);
    const std::uint64_t offsets_begin = begin + summary.size();
    summary.add(view(groups.offsets()));
    addHead(summary, Opcode::Footer, 8 + 8 + 4);
    summary.add(begin);
    summary.add(offsets_begin);
    return summary;
}

void McapWriter::finish() {
    if (chunk_.size() > 0)
        sendChunk();
    ByteBuffer end;
    end.add(std::uint32_t{0}); // No checksum of all data: each chunk has its own.
    ByteBuffer record;
    addRecord(record, Opcode::DataEnd, end);
    send(record);
    ByteBuffer foot = summary(sent_);
    foot.add(link::recording::checksum(view(foot)));
    foot.add(magic);
    send(foot);
}

} // namespace usar::mission
