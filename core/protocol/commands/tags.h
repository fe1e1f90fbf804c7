// SET commands for readers and releasers of RFID tags.
#pragma once

#include "core/protocol/commands/checked_text.h"
#include "core/protocol/commands/set_word.h"

namespace usar::protocol {

/// Read of an RFID reader: asks for the memory of a tag in reach.
/// On the wire: `SET {Type RFID} {Name RFID} {Opcode Read} {Params 118}`.
struct ReadTag {
    Token tag_id;
    Name reader_name{};
    bool operator==(const ReadTag&) const = default;

    static constexpr auto& word = set_word;
    static void segments(auto& io, auto& set) {
        setSegments(io, "RFID", set.reader_name, "Read");
        io.text({"Params", "RFID: id and text"}, set.tag_id);
    }
};
/// Write of an RFID reader: stores a text in a tag in reach.
/// On the wire: `SET {Type RFID} {Name RFID} {Opcode Write} {Params 118 visited by robot 2}`.
struct WriteTag {
    Token tag_id;
    Text memory{};
    Name reader_name{};
    bool operator==(const WriteTag&) const = default;

    static constexpr auto& word = set_word;
    static void segments(auto& io, auto& set) {
        setSegments(io, "RFID", set.reader_name, "Write");
        io.tagAndText({"Params", "RFID: id and text"}, set.tag_id, set.memory);
    }
};
/// Release of an RFIDReleaser: drops a tag.
/// On the wire: `SET {Type RFIDReleaser} {Name Gun} {Opcode Release}`.
struct ReleaseTag {
    Name releaser_name{};
    bool operator==(const ReleaseTag&) const = default;

    static constexpr auto& word = set_word;
    static void segments(auto& io, auto& set) { setSegments(io, "RFIDReleaser", set.releaser_name, "Release"); }
};
/// TagsRemaining of an RFIDReleaser: asks how many tags are left.
/// On the wire: `SET {Type RFIDReleaser} {Name Gun} {Opcode TagsRemaining}`.
struct CountTags {
    Name releaser_name{};
    bool operator==(const CountTags&) const = default;

    static constexpr auto& word = set_word;
    static void segments(auto& io, auto& set) { setSegments(io, "RFIDReleaser", set.releaser_name, "TagsRemaining"); }
};

} // namespace usar::protocol
