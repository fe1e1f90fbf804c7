// The verbs of usar-mission that read files and print a report: `lines`, `check-plan` and `plan-report`, and those that
// convert recordings to text and back, or to MCAP.
#pragma once

#include <functional>

#include <QIODevice>
#include <QStringList>

#include "core/base/result.h"
#include "core/mission/files/replay_options.h"

namespace usar::mission {

/// Input and output of a verb. The devices are open and belong to the caller.
struct VerbStreams {
    QIODevice& input;  ///< used for the file name "-"
    QIODevice& output; ///< for the report
    /// Called with each sentence for the user, without a line end.
    std::function<void(const std::string&)> complain;
};

/// True for "lines", "check-plan" and "plan-report".
bool isReportVerb(const QString& word);
/// Runs the verb that `arguments` begin with, which must be one of these three. Returns the exit code: 0 if all is
/// well, 1 if a line or plan has an error, 2 if a file cannot be read or the call is wrong. A file that cannot be read
/// is complained about, and the other files are still read. `plugin_folders`: where robots are looked for.
///   lines FILE                        prints one JSON object per protocol line
///   check-plan [--robot NAME] FILE…   checks POSH plans, also against a robot; prints one JSON object per finding
///   plan-report [--json] FILE…        reports on the runs of POSH plans in recordings and trace files
int runReportVerb(const QStringList& arguments, const QStringList& plugin_folders, const VerbStreams& streams);

/// Converts a recording to text or back, as `options.verb` says, and returns the exit code. The output file must not
/// exist before, and is removed if the conversion fails.
int convertRecording(const ReplayOptions& options, const VerbStreams& streams);

/// Exports a recording as MCAP, and returns the exit code: 1 if a part of the recording is missing. The output file
/// must not exist before, and appears when it is complete.
int exportRecording(const ReplayOptions& options, const VerbStreams& streams);

} // namespace usar::mission
