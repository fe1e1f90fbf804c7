// The byte format of recorded traces, shared by the encoder and the reader.
//
// A file consists of the magic and frames. A frame is a length (varint; of the rest of the frame), a kind (one byte)
// and a body. A cycle is coded as its difference from the previous cycle, by operations on the list of events; key
// frames do not depend on earlier frames. A sense with a cached answer is coded without the answer.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/base/byte_codec.h"
#include "core/posh/run/trace_event.h"

namespace usar::posh::trace_codec {

constexpr std::string_view magic = "USARPOSH1\n"; ///< includes the version
constexpr int cycles_per_key = 256;
constexpr std::size_t longest_frame = std::size_t{1} << 24; ///< bytes; a longer frame counts as incomplete

enum class Frame : std::uint8_t {
    Plan = 'P',   ///< the text of the plan that the following frames belong to
    Key = 'K',    ///< cycle number, time (zigzag), operations on an empty list; the numbering of texts starts again
    Delta = 'D',  ///< time step minus the previous time step (zigzag), operations on the previous cycle
    Between = 'B' ///< new events after the end of a cycle; delta frames do not depend on it
};

/// An operation on the events of the previous cycle. It is coded as a varint: the count times four, plus one of these.
enum class Operation : std::uint64_t {
    Copy = 0,   ///< `count` events are unchanged
    Change = 1, ///< one event differs in the fields named by a mask, which follows
    Insert = 2, ///< a new event follows
    Skip = 3,   ///< `count` events are dropped
};

// The bits of the mask of a Change; the new values follow it in this order.
constexpr std::uint8_t payload_changes = 1;
constexpr std::uint8_t detail_changes = 2;
constexpr std::uint8_t flags_change = 4;
constexpr std::uint8_t kind_changes = 8;
constexpr std::uint8_t text_changes = 16;

/// One event with its text.
struct Entry {
    TraceRecord record;
    std::uint32_t text = 0; ///< number of the text, counting from 1 since the last key frame; 0 means no text
    bool operator==(const Entry&) const = default;
};

} // namespace usar::posh::trace_codec
