// The table of reading functions: rows for all sensors, and for everything else that a server sends.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/protocol/info_message.h"
#include "core/protocol/readers/line_reading.h"

namespace usar::protocol {

/// One row. It applies to lines with this type word and this value of the Type segment (empty matches any), both
/// compared ignoring case, for which `fits`, unless null, returns true. `read` fills the alternative of InfoMessage
/// with the index `kind`, which the message must already hold; it returns false if the line must stay generic.
struct ReaderRow {
    std::string_view type_word;
    std::string_view type;
    bool (*fits)(const Segments& segments) = nullptr;
    std::size_t kind = 0;
    bool (*read)(LineReading& line, InfoMessage& message) = nullptr;
};

/// The first row that applies to the line, or nullptr.
const ReaderRow* readerRowFor(const Segments& segments);

} // namespace usar::protocol
