// What a campaign and its workers say to each other: `usar-mission worker` reads requests and tells how each run ended.
#pragma once

#include <optional>

#include <QByteArray>
#include <QStringList>

namespace usar::campaign {

/// The verb of usar-mission that reads requests from standard input until that ends.
inline constexpr const char* worker_verb = "worker";

/// A line that asks for a run: the arguments of usar-mission for it, each percent-encoded, separated by spaces.
QByteArray writeRunRequest(const QStringList& arguments);
QStringList readRunRequest(const QByteArray& line);

/// How a run's process ended, as far as the system tells.
struct RunEnd {
    bool by_signal = false;
    int code = 0; ///< the exit code, or the number of the signal
    bool operator==(const RunEnd&) const = default;
};

/// A line of its own, "ended 0" or "ended by 11", after which nothing more comes from the run. A worker writes it to
/// standard output and to standard error, so that its reader knows that it has all of both.
QByteArray write(const RunEnd& end);

/// Takes that line off the end of what a worker has written so far; nullopt if it has not come yet.
std::optional<RunEnd> takeRunEnd(QByteArray& written);

} // namespace usar::campaign
