#include "app/cli/run_worker.h"

#include <cstdio>
#include <fcntl.h>
#include <iostream>
#include <string>

#include <csignal>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/cli/console.h"
#include "core/campaign/runs/run_request.h"
#include "core/mission/runs/mission_runner.h"

namespace usar::app {

namespace {

/// Flies in the copy of the process, and ends it. Nothing is cleaned up, because it all belongs to the original.
[[noreturn]] void flyAsCopy(const QStringList& arguments, Preloaded& loaded, ::pid_t original) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != original)
        ::_exit(mission::BadInput); // The original has ended before it could be asked to take this one along.
    if (const int nothing = ::open("/dev/null", O_RDONLY); nothing >= 0)
        ::dup2(nothing, STDIN_FILENO); // The next requests are not for this one.
    const int code = flyMission(arguments, loaded);
    std::fflush(nullptr);
    ::_exit(code);
}

/// The end of a process by what waitpid says about it.
campaign::RunEnd endOf(int status) {
    return WIFSIGNALED(status) ? campaign::RunEnd{true, WTERMSIG(status)}
                               : campaign::RunEnd{false, WEXITSTATUS(status)};
}

} // namespace

int runWorker(Preloaded& loaded) {
    for (std::string line; std::getline(std::cin, line);) {
        const QStringList arguments = campaign::readRunRequest(QByteArray::fromStdString(line));
        preloadFor(arguments, loaded);
        std::fflush(nullptr); // Whatever waits to be written would be written by both.
        const ::pid_t original = ::getpid();
        const ::pid_t copy = ::fork();
        if (copy == 0)
            flyAsCopy(arguments, loaded, original);
        int status = 0;
        if (copy < 0 || ::waitpid(copy, &status, 0) != copy) {
            complain("no process could be started for the run");
            return mission::BadInput;
        }
        const QByteArray end = campaign::write(endOf(status));
        for (std::FILE* const stream : {stdout, stderr}) {
            std::fwrite(end.constData(), 1, static_cast<std::size_t>(end.size()), stream);
            std::fflush(stream);
        }
    }
    return 0;
}

} // namespace usar::app
