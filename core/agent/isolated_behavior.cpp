#include "core/agent/isolated_behavior.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QFile>

#include "core/base/numbers.h"

namespace usar::agent {

namespace {

/// Of a process, its libraries and the plugin's constructor.
constexpr Seconds patience_at_start{15.0};
constexpr std::size_t words_of_a_line = 60;
/// Where the host finds its end of the connection.
constexpr int host_socket = 3;

std::string signalInWords(int signal) {
    const char* const name = ::sigabbrev_np(signal);
    return name ? "SIG" + std::string(name) + " (" + ::strsignal(signal) + ")" : "signal " + std::to_string(signal);
}

/// Can be read from when the process is over; below 0 where the system has no such thing.
int handleOf(int process) {
    // The header of glibc 2.36 declares pidfd_open for C alone.
    return static_cast<int>(::syscall(SYS_pidfd_open, process, 0));
}

/// Waits for the end of a process that is as good as over, at most so long; nothing where it lives on.
std::optional<int> statusOf(int process, std::chrono::milliseconds patience) {
    if (const int handle = handleOf(process); handle >= 0) {
        pollfd its_end{handle, POLLIN, 0};
        ::poll(&its_end, 1, static_cast<int>(patience.count()));
        ::close(handle);
    }
    int status = 0;
    return ::waitpid(process, &status, WNOHANG) == process ? std::optional(status) : std::nullopt;
}

} // namespace

IsolatedBehavior::IsolatedBehavior(QString program, frames::Start start)
    : program_(std::move(program))
    , start_(std::move(start))
    , safe_(lastResort(protocol::VehicleKind::Unknown)) {}

IsolatedBehavior::~IsolatedBehavior() {
    closeHandles();
    channel_.reset(); // it ends by that, if it is well
    if (process_ > 0 && !statusOf(process_, std::chrono::milliseconds(200)))
        kill();
}

void IsolatedBehavior::closeHandles() {
    for (int* handle : {&end_handle_, &process_handle_})
        if (const int open = std::exchange(*handle, -1); open >= 0)
            ::close(open);
}

/// A process may be gone and its end of the connection open still, where it has left children behind.
void IsolatedBehavior::watchForItsEnd() {
    process_handle_ = handleOf(process_);
    channel_->endWith(process_handle_);
    end_handle_ = ::epoll_create1(EPOLL_CLOEXEC);
    epoll_event readable{};
    readable.events = EPOLLIN;
    for (const int handle : {channel_->socket(), process_handle_})
        if (handle >= 0)
            ::epoll_ctl(end_handle_, EPOLL_CTL_ADD, handle, &readable);
}

void IsolatedBehavior::kill() {
    if (process_ > 0)
        ::kill(process_, SIGKILL);
    reap();
}

/// One that is being dumped to the disk takes its time.
void IsolatedBehavior::reap() {
    if (process_ > 0)
        std::thread([process = std::exchange(process_, 0)] { ::waitpid(process, nullptr, 0); }).detach();
}

Result<void> IsolatedBehavior::startProcess() {
    const auto wrong = [this](const std::string& what) {
        return failure("it cannot run in a process of its own: " + what, "behavior " + start_.behavior_id,
                       "Install or build usar-behavior-host, or let it run in the program itself");
    };
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
        return wrong(std::strerror(errno));
    channel_ = std::make_unique<FrameChannel>(ends[0]);
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawnattr_init(&attributes);
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO); // our output is for our words
    ::posix_spawn_file_actions_adddup2(&actions, ends[1], host_socket);
    // Ctrl+C in a terminal is for us, who then end it in order.
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    QByteArray path = QFile::encodeName(program_);
    QByteArray option = QByteArray::number(host_socket);
    char* arguments[] = {path.data(), option.data(), nullptr};
    const int error = ::posix_spawn(&process_, path.constData(), &actions, &attributes, arguments, ::environ);
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    if (error == 0) {
        watchForItsEnd();
        return {};
    }
    process_ = 0;
    return wrong(program_.toStdString() + ": " + std::strerror(error));
}

RunningBehavior::Output IsolatedBehavior::begin() {
    if (const auto started = startProcess(); !started)
        return end(started.error().text());
    return ask(start_, patience_at_start, "it was being made");
}

RunningBehavior::Output IsolatedBehavior::receive(const protocol::InfoLine& line) {
    last_line_ = line.number;
    last_text_ = line.text.substr(0, words_of_a_line);
    if (last_text_.size() < line.text.size())
        last_text_ += "…";
    return ask(frames::Line{line.number, line.text}, patience_, "it worked on line");
}

RunningBehavior::Output IsolatedBehavior::order(Order order) {
    return ask(order, patience_, "it took an order after line");
}

RunningBehavior::Output IsolatedBehavior::control(const PlanControl& control) {
    return ask(control, patience_, "its plan was being changed after line");
}

void IsolatedBehavior::setParameters(const ParameterSet& parameters) {
    owed_ = ask(parameters.values(), patience_, "it took new parameters after line");
}

CausedCommand IsolatedBehavior::safeCommand(const std::string& source) const {
    return {safe_, {source, last_line_}};
}

RunningBehavior::Output IsolatedBehavior::ask(const frames::Request& request, Seconds patience,
                                              const std::string& at_work) {
    if (finished_ || ending_ || !channel_)
        return std::exchange(owed_, {});
    QByteArray frame;
    FrameChannel::Received received = FrameChannel::Received::Closed;
    if (channel_->send(frames::write(request), patience))
        received = channel_->receive(frame, patience);
    if (received == FrameChannel::Received::TimedOut) {
        kill();
        return die("hangs: it has not answered for " + fixed(patience.count(), 1) + " s and was ended", at_work);
    }
    std::optional<frames::Reply> reply;
    if (received == FrameChannel::Received::Frame)
        reply = frames::readReply(frame);
    if (reply && std::holds_alternative<frames::Answer>(*reply))
        return take(std::get<frames::Answer>(*reply));
    if (reply && std::holds_alternative<frames::Refusal>(*reply))
        return end(std::get<frames::Refusal>(*reply).error.text());
    if (reply && std::holds_alternative<frames::Dying>(*reply))
        return die(howItDied(std::get<frames::Dying>(*reply).signal), at_work);
    return lose(at_work);
}

RunningBehavior::Output IsolatedBehavior::take(frames::Answer& answer) {
    halted_ = answer.halted;
    finished_ = answer.finished;
    broke_ = answer.broke;
    safe_ = std::move(answer.safe);
    if (!answer.output.commands.empty())
        last_decision_ = answer.output.commands.back().cause.source;
    for (const Published& value : answer.output.published)
        if (const auto* const status = std::get_if<BehaviorStatus>(&value))
            last_state_ = status->state;
    Output output = std::exchange(owed_, {});
    output.append(std::move(answer.output));
    return output;
}

RunningBehavior::Output IsolatedBehavior::takeEnd() {
    if (ending_)
        return die(howItDied(std::nullopt), lost_at_work_);
    if (finished_ || !channel_)
        return {};
    QByteArray frame;
    const FrameChannel::Received received = channel_->receive(frame, Seconds{0.0});
    if (received == FrameChannel::Received::TimedOut)
        return {}; // nothing has come after all
    const auto reply = frames::readReply(frame);
    const std::string at_work = "it waited after line";
    if (reply && std::holds_alternative<frames::Dying>(*reply))
        return die(howItDied(std::get<frames::Dying>(*reply).signal), at_work);
    return lose(at_work);
}

RunningBehavior::Output IsolatedBehavior::lose(const std::string& at_work) {
    ending_ = true;
    halted_ = false;
    lost_at_work_ = at_work;
    closeHandles(); // or they would tell of it for ever
    owed_.commands = {safeCommand(start_.behavior_id + ": its process has ended")};
    return std::exchange(owed_, {});
}

std::string IsolatedBehavior::howItDied(std::optional<int> signal) {
    if (signal)
        return "died by " + signalInWords(*signal);
    const auto status = process_ > 0 ? statusOf(process_, std::chrono::milliseconds(500)) : std::nullopt;
    if (status)
        process_ = 0;
    else
        kill(); // it hung up and lives on
    if (status && WIFSIGNALED(*status))
        return "died by " + signalInWords(WTERMSIG(*status));
    if (status && WIFEXITED(*status))
        return "ended its process with exit code " + std::to_string(WEXITSTATUS(*status));
    return "broke the connection to its process";
}

/// The robot first: the words may be long.
RunningBehavior::Output IsolatedBehavior::die(const std::string& how, const std::string& at_work) {
    std::string reason = "The behavior " + start_.behavior_id + " " + how + ", while " + at_work;
    if (last_line_.value > 0)
        reason += " " + std::to_string(last_line_.value) + " (" + last_text_ + ")";
    if (!last_state_.empty())
        reason += "; its state was “" + last_state_ + "”";
    if (!last_decision_.empty())
        reason += "; its last command came from “" + last_decision_ + "”";
    broke_ = true;
    return end(reason + ". The robot was stopped; the behavior can be started again.");
}

RunningBehavior::Output IsolatedBehavior::end(const std::string& reason) {
    finished_ = true;
    ending_ = halted_ = false;
    closeHandles();
    channel_.reset(); // a host that is well ends by that
    reap();
    Output output = std::exchange(owed_, {});
    output.commands = {safeCommand(start_.behavior_id + ": its process has ended")};
    output.published.push_back(BehaviorFinished{false, reason});
    return output;
}

} // namespace usar::agent
