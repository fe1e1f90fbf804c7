#include "tests/doubles/mcap_file.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <QJsonDocument>

namespace usar::doubles {

namespace {

/// CRC-32 bit by bit, so that no library's checksum is compared with itself.
std::uint32_t crc32Of(std::string_view bytes) {
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const char byte : bytes) {
        crc ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ ((crc & 1u) != 0 ? 0xEDB88320u : 0u);
    }
    return ~crc;
}

/// Takes little-endian values from the front of bytes; throws where they end too early.
class McapBytes {
public:
    explicit McapBytes(std::string_view bytes) : rest_(bytes) {}

    template <class Number>
    Number number() {
        const std::string_view bytes = take(sizeof(Number));
        std::uint64_t value = 0;
        for (std::size_t place = sizeof(Number); place-- > 0;)
            value = value << 8 | static_cast<unsigned char>(bytes[place]);
        return static_cast<Number>(value);
    }
    std::string_view take(std::uint64_t count) {
        if (count > rest_.size())
            throw std::runtime_error("a record ends too early");
        const std::string_view taken = rest_.substr(0, static_cast<std::size_t>(count));
        rest_.remove_prefix(static_cast<std::size_t>(count));
        return taken;
    }
    std::string_view text() { return take(number<std::uint32_t>()); }
    bool empty() const { return rest_.empty(); }
    std::size_t left() const { return rest_.size(); }

private:
    std::string_view rest_;
};

constexpr std::string_view magic{"\x89MCAP0\r\n", 8};

/// Reads one file, and throws at the first thing that is not as specified.
class Reading {
public:
    explicit Reading(const std::string& bytes) : bytes_(bytes) {
        need(bytes_.starts_with(magic) && bytes_.ends_with(magic) && bytes_.size() > 2 * magic.size(), "no magic");
        readData();
        readSummary();
    }

    McapFile file;

private:
    struct Record {
        int opcode = 0;
        std::string_view content;
        std::size_t begin = 0; ///< in the file
        std::size_t end = 0;
    };
    struct Channel {
        std::string topic;
        std::uint16_t schema = 0;
        std::string record;
        std::uint64_t messages = 0;
    };
    struct Chunk {
        Record record;
        std::string_view records;
        std::uint64_t first_ns = 0;
        std::uint64_t last_ns = 0;
        std::map<std::uint16_t, std::size_t> indexes; ///< where in the file, by channel
        std::map<std::uint16_t, std::size_t> messages;
        std::size_t indexes_end = 0;
    };

    static void need(bool holds, const std::string& otherwise) {
        if (!holds)
            throw std::runtime_error(otherwise);
    }

    Record recordAt(std::size_t offset) const {
        McapBytes bytes(std::string_view(bytes_).substr(offset));
        Record record;
        record.begin = offset;
        record.opcode = bytes.number<std::uint8_t>();
        record.content = bytes.take(bytes.number<std::uint64_t>());
        record.end = offset + 9 + record.content.size();
        return record;
    }

    void readData() {
        Record record = recordAt(magic.size());
        need(record.opcode == 1, "no header");
        McapBytes header(record.content);
        need(header.text().empty(), "a profile");
        file.library = header.text();
        for (record = recordAt(record.end); record.opcode != 15; record = recordAt(record.end)) {
            need(record.opcode == 6 || record.opcode == 7, "neither a chunk nor an index");
            if (record.opcode == 6)
                readChunk(record);
            else
                readIndex(record);
        }
        need(record.content.size() == 4, "the end of the data has another length");
        data_end_ = record.end;
    }

    void readChunk(const Record& record) {
        McapBytes bytes(record.content);
        Chunk chunk;
        chunk.record = record;
        chunk.first_ns = bytes.number<std::uint64_t>();
        chunk.last_ns = bytes.number<std::uint64_t>();
        const auto size = bytes.number<std::uint64_t>();
        const auto crc = bytes.number<std::uint32_t>();
        need(bytes.text().empty(), "a compressed chunk");
        need(bytes.number<std::uint64_t>() == size && bytes.left() == size, "a chunk has another size");
        chunk.records = bytes.take(size);
        need(crc == crc32Of(chunk.records), "a chunk's checksum is wrong");
        std::uint64_t first_ns = UINT64_MAX, last_ns = 0;
        for (McapBytes records(chunk.records); !records.empty();) {
            const int opcode = records.number<std::uint8_t>();
            const std::string_view content = records.take(records.number<std::uint64_t>());
            if (opcode == 3)
                takeSchema(content);
            else if (opcode == 4)
                takeChannel(content);
            else
                need(opcode == 5, "a strange record in a chunk");
            if (opcode != 5)
                continue;
            ++chunk.messages[takeMessage(content)];
            first_ns = std::min(first_ns, file.messages.back().logged_ns);
            last_ns = std::max(last_ns, file.messages.back().logged_ns);
        }
        need(chunk.messages.empty() || (chunk.first_ns == first_ns && chunk.last_ns == last_ns), "a chunk's times");
        chunk.indexes_end = record.end;
        file.longest_chunk = std::max(file.longest_chunk, chunk.records.size());
        chunks_.push_back(std::move(chunk));
        file.chunks = chunks_.size();
    }

    void takeSchema(std::string_view content) {
        McapBytes bytes(content);
        const auto id = bytes.number<std::uint16_t>();
        const std::string name(bytes.text());
        need(id != 0 && bytes.text() == "jsonschema" && !schema_names_.contains(id), "a strange schema");
        file.schemas[name] = bytes.text();
        schema_names_[id] = name;
        schema_records_[id] = content;
    }

    void takeChannel(std::string_view content) {
        McapBytes bytes(content);
        const auto id = bytes.number<std::uint16_t>();
        Channel channel{.topic = {}, .schema = bytes.number<std::uint16_t>(), .record = std::string(content)};
        channel.topic = bytes.text();
        need(schema_names_.contains(channel.schema) && bytes.text() == "json" && !channels_.contains(id),
             "a strange channel");
        need(bytes.text().empty() && bytes.empty(), "a channel's metadata");
        channels_[id] = channel;
    }

    std::uint16_t takeMessage(std::string_view content) {
        McapBytes bytes(content);
        const auto id = bytes.number<std::uint16_t>();
        const auto channel = channels_.find(id);
        need(channel != channels_.end(), "a message of an unknown channel");
        McapMessage message{.topic = channel->second.topic, .schema = schema_names_[channel->second.schema]};
        message.sequence = bytes.number<std::uint32_t>();
        message.logged_ns = bytes.number<std::uint64_t>();
        message.published_ns = bytes.number<std::uint64_t>();
        message.data = bytes.take(bytes.left());
        need(message.sequence == channel->second.messages++, "a message's number");
        need(!message.json().isEmpty(), "a message is no JSON object: " + message.data.substr(0, 200));
        file.messages.push_back(std::move(message));
        return id;
    }

    void readIndex(const Record& record) {
        need(!chunks_.empty() && chunks_.back().indexes_end == record.begin, "an index without its chunk");
        Chunk& chunk = chunks_.back();
        McapBytes bytes(record.content);
        const auto id = bytes.number<std::uint16_t>();
        McapBytes entries(bytes.text());
        need(bytes.empty() && !chunk.indexes.contains(id), "a strange index");
        std::size_t count = 0;
        for (; !entries.empty(); ++count) {
            const auto time_ns = entries.number<std::uint64_t>();
            McapBytes at(chunk.records.substr(static_cast<std::size_t>(entries.number<std::uint64_t>())));
            need(at.number<std::uint8_t>() == 5, "an index points at no message");
            at.take(8);
            need(at.number<std::uint16_t>() == id, "an index points at another channel");
            at.take(4);
            need(at.number<std::uint64_t>() == time_ns, "an index has another time");
        }
        need(count == chunk.messages[id], "an index misses messages");
        chunk.indexes[id] = record.begin;
        chunk.indexes_end = record.end;
    }

    void readSummary() {
        constexpr std::size_t foot_bytes = 9 + 20;
        const std::size_t foot_begin = bytes_.size() - magic.size() - foot_bytes;
        const Record foot = recordAt(foot_begin);
        McapBytes bytes(foot.content);
        need(foot.opcode == 2 && foot.content.size() == 20, "no foot");
        const auto begin = bytes.number<std::uint64_t>();
        const auto offsets = bytes.number<std::uint64_t>();
        need(begin == data_end_, "the foot points elsewhere");
        const std::string_view summed =
            std::string_view(bytes_).substr(begin, bytes_.size() - magic.size() - 4 - begin);
        need(bytes.number<std::uint32_t>() == crc32Of(summed), "the summary's checksum is wrong");
        std::map<int, std::pair<std::size_t, std::size_t>> groups;
        Record record = recordAt(begin);
        std::size_t chunk = 0;
        for (; record.begin < offsets; record = recordAt(record.end)) {
            auto& group = groups.try_emplace(record.opcode, record.begin, record.begin).first->second;
            need(group.second == record.begin, "the summary is not in groups");
            group.second = record.end;
            readSummaryRecord(record, chunk);
        }
        need(chunk == chunks_.size() && record.begin == offsets, "the summary misses chunks");
        for (; record.opcode == 14; record = recordAt(record.end)) {
            McapBytes offset(record.content);
            const auto group = groups.find(offset.number<std::uint8_t>());
            need(group != groups.end() && offset.number<std::uint64_t>() == group->second.first &&
                     offset.number<std::uint64_t>() == group->second.second - group->second.first,
                 "a summary offset points elsewhere");
            groups.erase(group);
        }
        need(groups.empty() && record.begin == foot_begin, "summary offsets are missing");
    }

    void readSummaryRecord(const Record& record, std::size_t& chunk) {
        McapBytes bytes(record.content);
        if (record.opcode == 3)
            need(record.content == schema_records_[bytes.number<std::uint16_t>()], "another schema in the summary");
        else if (record.opcode == 4)
            need(record.content == channels_[bytes.number<std::uint16_t>()].record, "another channel in the summary");
        else if (record.opcode == 8)
            checkChunkIndex(bytes, chunks_.at(chunk++));
        else if (record.opcode == 11)
            checkStatistics(bytes);
        else
            need(false, "a strange record in the summary");
    }

    static void checkChunkIndex(McapBytes bytes, const Chunk& chunk) {
        need(bytes.number<std::uint64_t>() == chunk.first_ns && bytes.number<std::uint64_t>() == chunk.last_ns,
             "a chunk index has other times");
        need(bytes.number<std::uint64_t>() == chunk.record.begin &&
                 bytes.number<std::uint64_t>() == chunk.record.end - chunk.record.begin,
             "a chunk index points elsewhere");
        std::map<std::uint16_t, std::size_t> indexes;
        for (McapBytes map(bytes.text()); !map.empty();) {
            const auto id = map.number<std::uint16_t>();
            indexes[id] = map.number<std::uint64_t>();
        }
        need(indexes == chunk.indexes, "a chunk index points at other indexes");
        need(bytes.number<std::uint64_t>() == chunk.indexes_end - chunk.record.end, "the length of the indexes");
        need(bytes.text().empty(), "a compression");
        need(bytes.number<std::uint64_t>() == chunk.records.size() &&
                 bytes.number<std::uint64_t>() == chunk.records.size(),
             "a chunk index has another size");
    }

    void checkStatistics(McapBytes bytes) const {
        std::uint64_t first_ns = file.messages.empty() ? 0 : UINT64_MAX, last_ns = 0;
        for (const McapMessage& message : file.messages) {
            first_ns = std::min(first_ns, message.logged_ns);
            last_ns = std::max(last_ns, message.logged_ns);
        }
        need(bytes.number<std::uint64_t>() == file.messages.size(), "the count of messages");
        need(bytes.number<std::uint16_t>() == schema_names_.size(), "the count of schemas");
        need(bytes.number<std::uint32_t>() == channels_.size(), "the count of channels");
        need(bytes.number<std::uint64_t>() == 0, "attachments or metadata");
        need(bytes.number<std::uint32_t>() == chunks_.size(), "the count of chunks");
        need(bytes.number<std::uint64_t>() == first_ns && bytes.number<std::uint64_t>() == last_ns, "the times");
        std::size_t counted = 0;
        for (McapBytes map(bytes.text()); !map.empty(); ++counted) {
            const auto id = map.number<std::uint16_t>();
            need(map.number<std::uint64_t>() == channels_.at(id).messages, "the messages of a channel");
        }
        need(counted == channels_.size() && bytes.empty(), "a channel without a count");
    }

    const std::string& bytes_;
    std::map<std::uint16_t, std::string> schema_names_;
    std::map<std::uint16_t, std::string> schema_records_;
    std::map<std::uint16_t, Channel> channels_;
    std::vector<Chunk> chunks_;
    std::size_t data_end_ = 0;
};

} // namespace

QJsonObject McapMessage::json() const {
    return QJsonDocument::fromJson(QByteArray::fromStdString(data)).object();
}

std::vector<McapMessage> McapFile::of(const std::string& topic) const {
    std::vector<McapMessage> found;
    std::ranges::copy_if(messages, std::back_inserter(found),
                         [&](const McapMessage& message) { return message.topic == topic; });
    return found;
}

std::optional<McapFile> readMcap(const std::string& bytes, std::string& trouble) {
    try {
        return Reading(bytes).file;
    } catch (const std::exception& error) {
        trouble = error.what();
        return std::nullopt;
    }
}

} // namespace usar::doubles
