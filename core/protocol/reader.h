// Info lines to values.
#pragma once

#include <string_view>
#include <vector>

#include "core/protocol/info_message.h"
#include "core/protocol/readers/line_reading.h"
#include "core/protocol/segments.h"

namespace usar::protocol {

/// Reads the lines of one connection, both dialects, and numbers them from 1. Never fails: a line that no table knows
/// becomes a GenericMessage, a damaged one keeps what could be read and gets diagnostics. Values come out in SI units
/// and in our frame. Owned by one connection.
class Reader {
public:
    Reader();

    /// The line lives until the next call: its place is used again for the next one of its kind, so that reading
    /// allocates nothing in steady state. Copy what is to be kept.
    const InfoLine& read(std::string_view line);
    /// The next line gets the number after this one: in a replay, the number that it had.
    void continueAfter(LineNumber line) { last_ = line; }

private:
    void forgetBuffers();

    Segments segments_;
    std::vector<KeyedText> pairs_;
    Diagnostics diagnostics_;
    std::vector<InfoLine> places_; ///< one for each alternative of InfoMessage, holding it
    LineNumber last_;
    bool was_long_ = false; ///< the line before
};

} // namespace usar::protocol
