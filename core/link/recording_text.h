// A recording as plain text, one record a line, and back; without loss either way.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/link/recording_format.h"

namespace usar::link::recording {

/// The first line of the text form.
inline constexpr std::string_view text_title = "USAR recording, text form 1";

/// `KIND SECONDS LINE "bytes"`, and for Out and Note `KIND SECONDS LINE TRIGGER "name" "bytes"`, with its line end.
/// SECONDS have nine decimals; KIND is in, out, note … or the number of a kind that nobody here knows.
void appendText(std::string& text, const Record& record);

/// Reads one such line (without its line end) and keeps the texts that the record looks at.
class TextRecord {
public:
    /// The record lives until the next call. The error's `where` is the column, from 1, in words.
    Result<Record> read(std::string_view line);

private:
    std::string name_;
    std::string bytes_;
};

} // namespace usar::link::recording
