// Whole files: a recording to its text form, and a text form to a recording.
#pragma once

#include <QIODevice>
#include <QString>

#include "core/base/result.h"

namespace usar::link {

/// Damage becomes a comment with its place and size; the records around it are kept.
Result<void> recordingToText(const QString& recording_path, QIODevice& text);
/// Lines that are empty or begin with # are passed over. Errors name `text_name`, line and column; what was written
/// until then stays.
Result<void> textToRecording(QIODevice& text, const QString& text_name, QIODevice& recording);

} // namespace usar::link
