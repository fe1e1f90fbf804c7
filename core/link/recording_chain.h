// Finds the files of a recording that is in parts, and opens them.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <QString>

#include "core/base/result.h"
#include "core/link/recording_source.h"
#include "core/link/recording_survey.h"

namespace usar::link {

/// Quick: a file with an index, or with groups that are whole, is not read before it is played; what is damaged in it
/// joins the survey when `next` meets it.
enum class OpenMode { Thorough, Quick };

/// This is one file of a recording.
struct RecordingPart {
    std::string name; ///< It is the file's, without its folder.
    std::unique_ptr<RecordingFile> file;
    std::unique_ptr<RecordSource> source;
    RecordingSurvey survey;
    RecordTime begin{0};           ///< in the recording
    std::uint64_t begin_bytes = 0; ///< size of the files before
};

/// Holds the files of a recording that were found.
struct RecordingChain {
    std::vector<RecordingPart> parts; ///< at least one, in their order
    std::string broken;               ///< why those before them are missing; empty if none are
    std::string later;                ///< a sentence: others follow, which are not read; empty if none do
    std::string not_read;             ///< a sentence: the newest part cannot be read; empty if it can
    bool newest_begins = false;       ///< A program writes a further part, of which nothing is on the disk yet.
};

/// Opens the file and the parts before it, as far back as they lie beside it. If the file has nothing in it that can
/// be read, those that lie beside it are opened alone. Errors: nothing can be read.
Result<RecordingChain> openRecordingChain(const QString& path, OpenMode mode);

/// The number of a part as its facts tell it; 1 for a recording that is not in parts.
int partNumberOf(const RecordingSurvey& survey);

} // namespace usar::link
