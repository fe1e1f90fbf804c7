// A recording as plain text, one record per line, and back, without loss in either direction: single records, and whole
// files.
#pragma once

#include <string>
#include <string_view>

#include <QIODevice>
#include <QString>

#include "core/base/result.h"
#include "core/link/recording_format.h"

namespace usar::link {
namespace recording {

/// First line of the text form.
inline constexpr std::string_view text_title = "USAR recording, text form 1";

/// Appends `KIND SECONDS LINE "bytes"`, or for Out and Note `KIND SECONDS LINE TRIGGER "name" "bytes"`, with a line
/// end. SECONDS has nine decimals; KIND is in, out, note … or the number of an unknown kind.
void appendText(std::string& text, const Record& record);

/// Reads one such line (without its line end) and owns the texts to which the record refers.
class TextRecord {
public:
    /// The record is valid until the next call. The error's `where` is the column, counted from 1, in words.
    Result<Record> read(std::string_view line);

private:
    std::string name_;
    std::string bytes_;
};

} // namespace recording

/// Writes the text form to `text`, which must be open. A damaged stretch becomes a comment with its position and size;
/// the records around it are kept. Errors: the recording cannot be opened, or writing fails.
Result<void> recordingToText(const QString& recording_path, QIODevice& text);
/// Skips lines that are empty or begin with #. Errors name `text_name`, line and column; what was written to
/// `recording` until then stays.
Result<void> textToRecording(QIODevice& text, const QString& text_name, QIODevice& recording);

} // namespace usar::link
