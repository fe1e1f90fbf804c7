// Exports a recording as an MCAP file, for Foxglove and other programs of robotics.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>

#include <QIODevice>
#include <QString>

#include "core/base/clock.h"
#include "core/base/result.h"

namespace usar::mission {

/// What an export has written.
struct McapSummary {
    std::uint64_t messages = 0;
    std::uint64_t topics = 0;
    std::string complaint; ///< sentences about what is missing in the recording or was left out; empty: nothing
    bool damaged = false;  ///< They tell more than that parts of the recording are not there.
};

/// Called now and then with how much of the replay is exported, and of how much.
using McapProgress = std::function<void(Seconds done, Seconds whole)>;

/// Plays the recording without its pace, in an event loop of its own, and writes it to `output`, which is open. A
/// damaged recording is exported as far as it can be read. Its length costs no memory but its index. Errors: the
/// recording cannot be read, `output` takes no more, or `stop` was requested; what was written until then stays. Not
/// for the GUI thread.
Result<McapSummary> recordingToMcap(const QString& recording, QIODevice& output, const std::stop_token& stop = {},
                                    const McapProgress& progress = {});

/// The same into a file, which appears when it is complete. `replaces`: it may exist already; else that is an error, as
/// it always is if it is the recording itself.
Result<McapSummary> recordingToMcapFile(const QString& recording, const QString& file, bool replaces,
                                        const std::stop_token& stop = {}, const McapProgress& progress = {});

} // namespace usar::mission
