#include "core/server/embedded/quit_signals.h"

#include <array>
#include <csignal>

#include <unistd.h>

#include <QSocketNotifier>

namespace usar::server {

namespace {

std::array<int, 2> signal_pipe{-1, -1};

void onSignal(int number) {
    std::signal(number, SIG_DFL);
    const char byte = 1;
    [[maybe_unused]] const auto written = ::write(signal_pipe[1], &byte, 1);
}

} // namespace

QuitSignals::QuitSignals(QObject* parent) : QObject(parent) {
    if (::pipe(signal_pipe.data()) != 0)
        return; // Without the pipe, Ctrl+C just ends the program.
    auto* notifier = new QSocketNotifier(signal_pipe[0], QSocketNotifier::Read, this);
    connect(notifier, &QSocketNotifier::activated, this, [this, notifier] {
        notifier->setEnabled(false);
        emit quit();
    });
    std::signal(SIGINT, onSignal);
    std::signal(SIGTERM, onSignal);
}

QuitSignals::~QuitSignals() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    for (int& end : signal_pipe) {
        if (end >= 0)
            ::close(end);
        end = -1;
    }
}

} // namespace usar::server
