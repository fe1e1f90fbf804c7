// Signals to programs that a test has started.
#pragma once

#include <csignal>

#include <QtGlobal>

namespace usar::test {

/// Sends the signal (of <csignal>; 0 only asks whether there is such a process) to one process. False, with nothing
/// sent, where that process is not there: QProcess calls a process that has ended 0, and to the system, 0 and less mean
/// whole groups of processes, of which the test's own is one, with all other tests.
inline bool sendSignal(qint64 process, int signal_number) {
    return process > 1 && ::kill(static_cast<pid_t>(process), signal_number) == 0;
}

} // namespace usar::test
