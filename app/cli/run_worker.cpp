#include "app/cli/run_worker.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QDir>

#include "app/cli/console.h"
#include "core/base/result.h"
#include "core/campaign/runs/run_request.h"
#include "core/mission/runs/mission_runner.h"

namespace usar::app {

namespace {

volatile std::sig_atomic_t copy_id = 0; ///< process that flies; 0: none does
volatile std::sig_atomic_t is_to_end = 0;

void endWithCopy(int) {
    is_to_end = 1;
    if (copy_id > 0)
        ::kill(copy_id, SIGKILL);
}

/// Holds back SIGTERM while it lives.
class TermHeld {
public:
    TermHeld() {
        ::sigset_t term;
        ::sigemptyset(&term);
        ::sigaddset(&term, SIGTERM);
        ::sigprocmask(SIG_BLOCK, &term, &before_);
    }
    ~TermHeld() { ::sigprocmask(SIG_SETMASK, &before_, nullptr); }
    TermHeld(const TermHeld&) = delete;
    TermHeld& operator=(const TermHeld&) = delete;

private:
    ::sigset_t before_{};
};

/// A plugin may have started a thread, which no copy has.
bool hasOneThread() {
    return QDir("/proc/self/task").entryList(QDir::Dirs | QDir::NoDotAndDotDot).size() == 1;
}

/// Flies in the copy of the process, and ends it without cleaning up what belongs to the original.
[[noreturn]] void flyAsCopy(const QStringList& arguments, Preloaded& loaded, ::pid_t original, bool can_copy) {
    std::signal(SIGTERM, SIG_DFL);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != original)
        ::_exit(mission::BadInput); // The original has ended before it could be asked to take this one along.
    if (const int nothing = ::open("/dev/null", O_RDONLY); nothing >= 0)
        ::dup2(nothing, STDIN_FILENO); // The next requests are not for this one.
    if (!can_copy) {
        QList<QByteArray> words{"usar-mission"};
        for (const QString& argument : arguments)
            words << argument.toLocal8Bit();
        std::vector<char*> pointers;
        for (QByteArray& word : words)
            pointers.push_back(word.data());
        pointers.push_back(nullptr);
        ::execv("/proc/self/exe", pointers.data());
    }
    const int code = flyMission(arguments, loaded);
    std::fflush(nullptr);
    ::_exit(code);
}

/// Starts a copy that flies and waits for its end, which is what waitpid says; nullopt if it cannot be started.
std::optional<int> flyInCopy(const QStringList& arguments, Preloaded& loaded) {
    const ::pid_t original = ::getpid();
    const bool can_copy = hasOneThread();
    std::fflush(nullptr); // Whatever waits to be written would be written by both.
    {
        const TermHeld held; // The copy is to be known before it can be asked to end.
        copy_id = ::fork();
    }
    if (copy_id == 0)
        flyAsCopy(arguments, loaded, original, can_copy);
    if (copy_id < 0)
        return std::nullopt;
    int status = 0;
    while (::waitpid(copy_id, &status, 0) < 0 && errno == EINTR) {
    }
    copy_id = 0;
    return status;
}

/// The end of a process by what waitpid says about it.
campaign::RunEnd endOf(int status) {
    return WIFSIGNALED(status) ? campaign::RunEnd{true, WTERMSIG(status)}
                               : campaign::RunEnd{false, WEXITSTATUS(status)};
}

} // namespace

int runWorker(Preloaded& loaded) {
    struct ::sigaction ending {};
    ending.sa_handler = endWithCopy; // Without SA_RESTART, so that reading a request ends, too.
    ::sigaction(SIGTERM, &ending, nullptr);
    for (std::string line; is_to_end == 0 && std::getline(std::cin, line);) {
        const campaign::RunRequest request = campaign::readRunRequest(QByteArray::fromStdString(line));
        preloadFor(request.arguments, loaded);
        if (is_to_end != 0)
            break;
        const auto status = flyInCopy(request.arguments, loaded);
        if (!status) {
            complain(Error{"no process could be started for a run: " + std::string(std::strerror(errno)),
                           "usar-mission worker", "End other programs, or raise the limit of processes (ulimit -u)"}
                         .text());
            return mission::BadInput;
        }
        const QByteArray end = campaign::write(request.number, endOf(*status));
        for (std::FILE* const stream : {stdout, stderr}) {
            std::fwrite(end.constData(), 1, static_cast<std::size_t>(end.size()), stream);
            std::fflush(stream);
        }
    }
    return 0;
}

} // namespace usar::app
