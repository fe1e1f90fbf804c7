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
    template <class Io>
    static void segments(Io& io, Ref<Io, ReadTag> set) {
        io.mark(set_type, "RFID");
        io.text(set_name, set.reader_name);
        io.mark(set_opcode, "Read");
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
    template <class Io>
    static void segments(Io& io, Ref<Io, WriteTag> set) {
        io.mark(set_type, "RFID");
        io.text(set_name, set.reader_name);
        io.mark(set_opcode, "Write");
        io.tagAndText({"Params", "RFID: id and text"}, set.tag_id, set.memory);
    }
};
/// Release of an RFIDReleaser: drops a tag.
/// On the wire: `SET {Type RFIDReleaser} {Name Gun} {Opcode Release}`.
struct ReleaseTag {
    Name releaser_name{};
    bool operator==(const ReleaseTag&) const = default;

    static constexpr auto& word = set_word;
    template <class Io>
    static void segments(Io& io, Ref<Io, ReleaseTag> set) {
        io.mark(set_type, "RFIDReleaser");
        io.text(set_name, set.releaser_name);
        io.mark(set_opcode, "Release");
    }
};
/// TagsRemaining of an RFIDReleaser: asks how many tags are left.
/// On the wire: `SET {Type RFIDReleaser} {Name Gun} {Opcode TagsRemaining}`.
struct CountTags {
    Name releaser_name{};
    bool operator==(const CountTags&) const = default;

    static constexpr auto& word = set_word;
    template <class Io>
    static void segments(Io& io, Ref<Io, CountTags> set) {
        io.mark(set_type, "RFIDReleaser");
        io.text(set_name, set.releaser_name);
        io.mark(set_opcode, "TagsRemaining");
    }
};

} // namespace usar::protocol
