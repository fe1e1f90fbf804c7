// usar-behavior-host as a child: its process, the connection to it, and how it ended.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <QString>
#include <QTemporaryDir>

#include "core/agent/behavior_frames.h"
#include "core/agent/frame_channel.h"

namespace usar::agent {

/// Ends its process when it goes, and waits up to 200 ms for one that is well. Used from its owner's thread. POSIX
/// only; on other systems than Linux the end of the connection alone tells that it is gone. The process has a folder of
/// its own for temporary files, which goes with this, for one that is killed leaves all of them behind.
class HostProcess {
public:
    /// `program` is the path of usar-behavior-host. The error names `subject`, whatever is to have the process.
    static Result<std::unique_ptr<HostProcess>> start(const QString& program, const std::string& subject);
    ~HostProcess();
    Q_DISABLE_COPY_MOVE(HostProcess)

    /// Nothing in time: `TimedOut`. Its words are in `reply` where they are understood, else it counts as gone.
    FrameChannel::Received ask(const frames::Request& request, Seconds patience, std::optional<frames::Reply>& reply);
    /// Asks without waiting, also for the answer: `listen` has it once the end handle can be read from. False where it
    /// is gone. The request is smaller than what a socket takes in (some 200 kB).
    bool tell(const frames::Request& request);
    /// What has come; does not wait. `TimedOut` where nothing has, or only a part of it.
    FrameChannel::Received listen(std::optional<frames::Reply>& reply);

    /// 0 where there is none any more.
    int id() const { return process_; }
    /// Can be read from when the process or its end of the connection is gone, or has said something; -1 once `deaf`.
    int endHandle() const { return end_handle_; }
    void becomeDeaf();
    /// Can be read from when the process is over; -1 where the system has no such thing.
    int processHandle() const { return process_handle_; }
    void kill();
    /// Hangs up and lets it end by itself, however long that takes: it may be being dumped to the disk.
    void leave();
    /// "died by SIGSEGV (Segmentation fault)". `signal`: as its last words name it. Without them the process is waited
    /// for, so long at the most; one that lives on then is killed.
    std::string howItEnded(std::optional<int> signal, Seconds patience = Seconds{0.5});

private:
    HostProcess(int process, int socket, std::unique_ptr<QTemporaryDir> scratch);
    /// Without waiting for it.
    void reap();
    FrameChannel::Received take(std::optional<Seconds> patience, std::optional<frames::Reply>& reply);

    std::unique_ptr<QTemporaryDir> scratch_;
    int process_ = 0;
    std::optional<FrameChannel> channel_;
    int process_handle_ = -1; ///< can be read from when the process is over
    int end_handle_ = -1;     ///< of the process and the connection together
};

} // namespace usar::agent
