// The command line of `usar-mission replay`, `recording-to-text` and `text-to-recording`.
#pragma once

#include <limits>
#include <optional>

#include <QString>
#include <QStringList>

#include "core/base/clock.h"
#include "core/base/result.h"

namespace usar::mission {

enum class ReplayVerb { Replay, ToText, ToRecording };

struct ReplayOptions {
    ReplayVerb verb = ReplayVerb::Replay;
    QString file;
    QString output; ///< of a conversion; "-" is standard output
    double speed = std::numeric_limits<double>::infinity();
    Seconds from{0.0};
    std::optional<Seconds> to; ///< absent: to the end
    bool help = false;
    bool operator==(const ReplayOptions&) const = default;
};

bool isReplayVerb(const QString& word);
/// `arguments` without the program's name, the verb first.
Result<ReplayOptions> readReplayOptions(const QStringList& arguments);
/// Part of what `usar-mission --help` prints.
QString replayHelp();

} // namespace usar::mission
