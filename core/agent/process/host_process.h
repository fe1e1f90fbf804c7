// A child process that runs usar-behavior-host: the process, the connection to it, and the reason for its end.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <QString>
#include <QTemporaryDir>

#include "core/agent/process/behavior_frames.h"
#include "core/agent/process/frame_channel.h"

namespace usar::agent {

/// The destructor closes the connection, waits up to 200 ms for the process to end, and then kills it. Use it from the
/// owner's thread. POSIX only; on systems other than Linux, only the end of the connection shows that the process is
/// gone. The process has its own folder for temporary files, which is deleted when the process has ended, because a
/// killed process leaves its files behind.
class HostProcess {
public:
    /// `program` is the path of usar-behavior-host. The error names `subject`, the behavior or plugin that needs the
    /// process.
    static Result<std::unique_ptr<HostProcess>> start(const QString& program, const std::string& subject);
    ~HostProcess();
    Q_DISABLE_COPY_MOVE(HostProcess)

    /// Sends a request and waits for the reply. TimedOut if there is none within `patience`; Closed if the process is
    /// gone or its reply cannot be read.
    FrameChannel::Received ask(const frames::Request& request, Seconds patience, std::optional<frames::Reply>& reply);
    /// Sends a request without waiting; `listen` returns the reply once the end handle is readable. False if the
    /// process is gone. The request must fit into the socket's buffer (about 200 kB).
    bool tell(const frames::Request& request);
    /// Returns a reply that has arrived, without waiting. TimedOut if none, or only a part of one, has arrived.
    FrameChannel::Received listen(std::optional<frames::Reply>& reply) { return take(Seconds{0.0}, reply); }

    /// Process id; 0 if the process is known to have ended or has been given up.
    int id() const { return process_; }
    /// A file descriptor that becomes readable when the process sends something, ends or closes the connection; -1
    /// after `becomeDeaf`.
    int endHandle() const { return end_handle_; }
    /// Closes the end handle.
    void becomeDeaf();
    /// A file descriptor that becomes readable when the process ends; -1 if the system has none.
    int processHandle() const { return process_handle_; }
    /// Kills the process and waits up to 200 ms for its end, which takes longer only while it writes a core dump.
    void kill();
    /// Closes the connection and lets the process end by itself, however long it takes: it may be writing a core dump.
    void leave();
    /// "died by SIGSEGV (Segmentation fault)". `signal` is the number in its last frame (Dying). Without it, waits up
    /// to `patience` for the process to end, and kills it if it does not.
    std::string howItEnded(std::optional<int> signal, Seconds patience = Seconds{0.5});

private:
    HostProcess(int process, int socket, std::unique_ptr<QTemporaryDir> scratch);
    /// Collects the exit status in the background.
    void reap();
    FrameChannel::Received take(std::optional<Seconds> patience, std::optional<frames::Reply>& reply);

    std::unique_ptr<QTemporaryDir> scratch_;
    int process_ = 0;
    std::optional<FrameChannel> channel_;
    int process_handle_ = -1; ///< readable when the process has ended
    int end_handle_ = -1;     ///< an epoll descriptor for the process handle and the connection
};

} // namespace usar::agent
