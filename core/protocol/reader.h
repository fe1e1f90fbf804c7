// Converts info lines to values.
#pragma once

#include <string_view>
#include <vector>

#include "core/protocol/info_message.h"
#include "core/protocol/readers/line_reading.h"
#include "core/protocol/segments.h"

namespace usar::protocol {

/// Reads the lines of one connection in either dialect and numbers them from 1. Never fails: a line of unknown type
/// becomes a GenericMessage; a damaged line keeps what could be read, or becomes a GenericMessage, and gets
/// diagnostics. Values are in SI units and in our frame, except in a GenericMessage. Each connection owns one reader.
class Reader {
public:
    Reader() { forgetBuffers(); }

    /// Reads one line without its terminator. The result is valid until the next call: its memory is reused for the
    /// next line of its kind, so that reading allocates nothing in steady state. Copy what you want to keep.
    const InfoLine& read(std::string_view line);
    /// Gives the next line the number after `line`; a replay uses this to restore the recorded numbers.
    void continueAfter(LineNumber line) { last_ = line; }

private:
    void forgetBuffers();

    Segments segments_;
    std::vector<KeyedText> pairs_;
    Diagnostics diagnostics_;
    std::vector<InfoLine> places_; ///< one for each alternative of InfoMessage, in its order
    LineNumber last_;
    bool was_long_ = false; ///< the previous line was longer than what buffers may keep
};

} // namespace usar::protocol
