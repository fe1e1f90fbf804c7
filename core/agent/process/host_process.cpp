#include "core/agent/process/host_process.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QFile>

namespace usar::agent {

namespace {

/// The file descriptor under which the host finds its end of the connection.
constexpr int host_socket = 3;
/// A process ends within milliseconds of SIGKILL unless it is writing a core dump.
constexpr Seconds end_patience{0.2};

std::string signalInWords(int signal) {
    const char* const name = ::sigabbrev_np(signal);
    return name ? "SIG" + std::string(name) + " (" + ::strsignal(signal) + ")" : "signal " + std::to_string(signal);
}

/// Returns a file descriptor that becomes readable when the process ends; negative if the system has none.
int handleOf(int process) {
    // The header of glibc 2.36 declares pidfd_open for C only.
    return static_cast<int>(::syscall(SYS_pidfd_open, process, 0));
}

/// Waits up to `patience` for a process that is about to end, and returns its status; nullopt if it has not ended.
std::optional<int> statusOf(int process, Seconds patience) {
    if (const int handle = handleOf(process); handle >= 0) {
        pollfd its_end{handle, POLLIN, 0};
        ::poll(&its_end, 1, static_cast<int>(patience.count() * 1e3));
        ::close(handle);
    }
    int status = 0;
    return ::waitpid(process, &status, WNOHANG) == process ? std::optional(status) : std::nullopt;
}

/// Our environment with another folder for temporary files, unless there is none.
std::vector<char*> environmentWith(QByteArray& temporary_folder) {
    std::vector<char*> variables;
    for (char** each = ::environ; *each; ++each)
        if (std::strncmp(*each, "TMPDIR=", 7) != 0)
            variables.push_back(*each);
    if (!temporary_folder.isEmpty())
        variables.push_back(temporary_folder.data());
    variables.push_back(nullptr);
    return variables;
}

/// Starts the program. Returns the process id, or the negated error number.
int spawn(const QString& program, int socket, const QTemporaryDir& scratch) {
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawnattr_init(&attributes);
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO); // stdout belongs to this program
    ::posix_spawn_file_actions_adddup2(&actions, socket, host_socket);
    // Ctrl+C in a terminal must reach only this program, which then ends the process in an orderly way.
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    QByteArray path = QFile::encodeName(program);
    QByteArray option = QByteArray::number(host_socket);
    char* arguments[] = {path.data(), option.data(), nullptr};
    QByteArray folder = scratch.isValid() ? "TMPDIR=" + QFile::encodeName(scratch.path()) : QByteArray();
    int process = 0;
    const int error =
        ::posix_spawn(&process, path.constData(), &actions, &attributes, arguments, environmentWith(folder).data());
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&actions);
    return error == 0 ? process : -error;
}

} // namespace

Result<std::unique_ptr<HostProcess>> HostProcess::start(const QString& program, const std::string& subject) {
    const auto wrong = [&](const std::string& what) {
        return failure("it cannot run in a separate process: " + what, subject,
                       "Install or build usar-behavior-host, or let it run in the program itself");
    };
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        return wrong(std::strerror(errno));
    auto scratch = std::make_unique<QTemporaryDir>();
    const int process = spawn(program, ends[1], *scratch);
    ::close(ends[1]);
    if (process > 0)
        return std::unique_ptr<HostProcess>(new HostProcess(process, ends[0], std::move(scratch)));
    ::close(ends[0]);
    return wrong(program.toStdString() + ": " + std::strerror(-process));
}

/// Watches both the process and the connection, because the children of a dead process may keep the connection open.
HostProcess::HostProcess(int process, int socket, std::unique_ptr<QTemporaryDir> scratch)
    : scratch_(std::move(scratch))
    , process_(process)
    , process_handle_(handleOf(process)) {
    channel_.emplace(socket);
    channel_->endWith(process_handle_);
    end_handle_ = ::epoll_create1(EPOLL_CLOEXEC);
    epoll_event readable{};
    readable.events = EPOLLIN;
    for (const int handle : {socket, process_handle_})
        if (handle >= 0)
            ::epoll_ctl(end_handle_, EPOLL_CTL_ADD, handle, &readable);
}

HostProcess::~HostProcess() {
    becomeDeaf();
    channel_.reset(); // a healthy process ends because of this
    if (process_handle_ >= 0)
        ::close(process_handle_);
    if (process_ > 0 && !statusOf(process_, end_patience))
        kill();
}

void HostProcess::becomeDeaf() {
    if (const int open = std::exchange(end_handle_, -1); open >= 0)
        ::close(open);
}

void HostProcess::kill() {
    if (process_ <= 0)
        return;
    ::kill(process_, SIGKILL);
    if (statusOf(process_, end_patience))
        process_ = 0;
    else
        reap();
}

void HostProcess::leave() {
    becomeDeaf();
    channel_.reset();
    reap();
}

/// Waits in a thread, because a process that writes a core dump may take long to end. Its folder stays until then: a
/// process that finds no folder for temporary files writes to the root of the file system.
void HostProcess::reap() {
    if (process_ > 0)
        std::thread([process = std::exchange(process_, 0), scratch = std::move(scratch_)] {
            ::waitpid(process, nullptr, 0);
        }).detach();
}

FrameChannel::Received HostProcess::ask(const frames::Request& request, Seconds patience,
                                        std::optional<frames::Reply>& reply) {
    if (!channel_->send(frames::write(request), patience))
        return FrameChannel::Received::Closed;
    return take(patience, reply);
}

bool HostProcess::tell(const frames::Request& request) {
    return channel_->send(frames::write(request), Seconds{0.0});
}

FrameChannel::Received HostProcess::take(std::optional<Seconds> patience, std::optional<frames::Reply>& reply) {
    QByteArray frame;
    const FrameChannel::Received received = channel_->receive(frame, patience);
    if (received == FrameChannel::Received::Frame)
        reply = frames::readReply(frame);
    return received == FrameChannel::Received::Frame && !reply ? FrameChannel::Received::Closed : received;
}

std::string HostProcess::howItEnded(std::optional<int> signal, Seconds patience) {
    if (signal)
        return "died by " + signalInWords(*signal);
    const auto status = process_ > 0 ? statusOf(process_, patience) : std::nullopt;
    if (status)
        process_ = 0;
    else
        kill(); // it has closed the connection but still runs
    if (status && WIFSIGNALED(*status))
        return "died by " + signalInWords(WTERMSIG(*status));
    if (status && WIFEXITED(*status))
        return "ended its process with exit code " + std::to_string(WEXITSTATUS(*status));
    return "broke the connection to its process";
}

} // namespace usar::agent
