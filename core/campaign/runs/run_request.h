// The lines between a campaign and its workers: `usar-mission worker` reads requests and tells how each run ended.
#pragma once

#include <optional>

#include <QByteArray>
#include <QStringList>

namespace usar::campaign {

/// The verb of usar-mission that reads requests from standard input until that ends.
inline constexpr const char* worker_verb = "worker";

/// A run that a worker is to fly.
struct RunRequest {
    int number = 0;        ///< tells the answers of a worker apart
    QStringList arguments; ///< words of the command line after usar-mission
    bool operator==(const RunRequest&) const = default;
};

/// A line with the number and the arguments, each percent-encoded, separated by spaces.
QByteArray write(const RunRequest& request);
RunRequest readRunRequest(const QByteArray& line);

/// How a run's process ended, as far as the system tells.
struct RunEnd {
    bool by_signal = false;
    int code = 0; ///< the exit code, or the number of the signal
    bool operator==(const RunEnd&) const = default;
};

/// A line of its own, such as "ended 7 0" or "ended 7 by 11" for the request 7. A worker writes it to standard output
/// and to standard error, so that its reader knows that it has all of both.
QByteArray write(int number, const RunEnd& end);

/// Takes that line, and whatever somebody has written after it, off a worker's text; nullopt if it has not come yet.
std::optional<RunEnd> takeRunEnd(QByteArray& written, int number);

} // namespace usar::campaign
