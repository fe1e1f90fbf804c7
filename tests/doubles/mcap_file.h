// A strict reader of uncompressed MCAP files, written after the specification (mcap.dev/spec) and sharing no code with
// the writer.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QJsonObject>

namespace usar::doubles {

struct McapMessage {
    std::string topic{};
    std::string schema{}; ///< its name
    std::uint32_t sequence = 0;
    std::uint64_t logged_ns = 0;
    std::uint64_t published_ns = 0;
    std::string data{};

    QJsonObject json() const;
    bool operator==(const McapMessage&) const = default;
};

/// The content of a file.
struct McapFile {
    std::vector<McapMessage> messages; ///< in the order of the file
    std::string library;
    std::map<std::string, std::string> schemas; ///< text by name
    std::size_t chunks = 0;
    std::size_t longest_chunk = 0; ///< bytes of its records

    /// Those of one topic.
    std::vector<McapMessage> of(const std::string& topic) const;
};

/// The file that these bytes are. Nullopt, with the first thing in `trouble` that is not as specified, if they are
/// none: lengths, checksums, and all that indexes, statistics and the foot point to are checked, and that each message
/// is a JSON object.
std::optional<McapFile> readMcap(const std::string& bytes, std::string& trouble);

} // namespace usar::doubles
