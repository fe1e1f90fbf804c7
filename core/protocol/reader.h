// Info lines to values.
#pragma once

#include <string_view>

#include "core/protocol/info_message.h"
#include "core/protocol/segments.h"

namespace usar::protocol {

/// Reads the lines of one connection, both dialects, and numbers them from 1. Never fails: a line that no table knows
/// becomes a GenericMessage, a damaged one keeps what could be read and gets diagnostics. Values come out in SI units
/// and in our frame. Reused buffers make it cheap; owned by one connection.
class Reader {
public:
    InfoLine read(std::string_view line);
    /// The next line gets the number after this one: in a replay, the number that it had.
    void continueAfter(LineNumber line) { last_ = line; }

private:
    Segments segments_;
    LineNumber last_;
};

} // namespace usar::protocol
