// Which function reads which line: the table of sensors, and a row for everything else that a server says.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/protocol/info_message.h"
#include "core/protocol/readers/line_reading.h"

namespace usar::protocol {

/// `type` is the value of the Type segment; empty takes any. Both are compared without regard to case. `fits`, where
/// there is one, looks at the shape. `read` fills the alternative of number `kind`, which the message holds already;
/// false leaves the line generic.
struct ReaderRow {
    std::string_view type_word;
    std::string_view type;
    bool (*fits)(const Segments& segments) = nullptr;
    std::size_t kind = 0;
    bool (*read)(LineReading& line, InfoMessage& message) = nullptr;
};

/// The first row that fits the line, or nullptr.
const ReaderRow* readerRowFor(const Segments& segments);

} // namespace usar::protocol
