// The command line of `usar-mission replay`, `recording-to-text`, `text-to-recording` and `recording-to-mcap`.
#pragma once

#include <limits>
#include <optional>

#include <QString>
#include <QStringList>

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/usage/program.h"

namespace usar::mission {

/// The four subcommands.
enum class ReplayVerb { Replay, ToText, ToRecording, ToMcap };

/// Options of the four subcommands, with their defaults.
struct ReplayOptions {
    ReplayVerb verb = ReplayVerb::Replay;
    QString file;
    QString output; ///< target of a conversion; "-" is standard output
    double speed =
        std::numeric_limits<double>::infinity(); ///< multiple of the recording's pace; infinity: as fast as possible
    Seconds from{0.0};                           ///< since the recording began, like `to`
    std::optional<Seconds> to;                   ///< absent: to the end
    bool operator==(const ReplayOptions&) const = default;
};

/// Returns true for "replay", "recording-to-text", "text-to-recording" and "recording-to-mcap".
bool isReplayVerb(const QString& word);
/// Reads the command line; `arguments` begins with the verb and does not include the program's name.
Result<ReplayOptions> readReplayOptions(const QStringList& arguments);
/// The four in words.
QList<usage::Verb> replayVerbs();

} // namespace usar::mission
