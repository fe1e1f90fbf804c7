// Conversion of whole files: a recording to its text form, and a text form to a recording.
#pragma once

#include <QIODevice>
#include <QString>

#include "core/base/result.h"

namespace usar::link {

/// Writes the text form to `text`, which must be open. A damaged stretch becomes a comment with its position and size;
/// the records around it are kept. Errors: the recording cannot be opened, or writing fails.
Result<void> recordingToText(const QString& recording_path, QIODevice& text);
/// Skips lines that are empty or begin with #. Errors name `text_name`, line and column; what was written to
/// `recording` until then stays.
Result<void> textToRecording(QIODevice& text, const QString& text_name, QIODevice& recording);

} // namespace usar::link
