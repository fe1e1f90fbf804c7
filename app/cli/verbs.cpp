#include "app/cli/verbs.h"

#include <cstdio>

#include <unistd.h>

#include <QCoreApplication>
#include <QFile>
#include <QJsonDocument>
#include <QTimer>

#include "core/base/numbers.h"
#include "core/mission/reports/verbs.h"
#include "core/mission/runs/mission_runner.h"
#include "core/mission/runs/replay_runner.h"
#include "core/server/embedded/program_files.h"
#include "core/server/embedded/quit_signals.h"

namespace usar::app {

namespace {

void complain(const std::string& text) {
    std::fprintf(stderr, "usar-mission: %s\n", text.c_str());
}

int end(int exit_code, const QJsonObject& summary) {
    std::printf("%s\n", QJsonDocument(summary).toJson(QJsonDocument::Compact).constData());
    return exit_code;
}

int replay(const mission::ReplayOptions& options) {
    auto recording = link::RecordingReader::open(options.file);
    if (!recording) {
        complain(recording.error().text());
        return end(mission::BadInput, mission::refusedReplay(options.file, recording.error().text()));
    }
    const std::string complaint = (*recording)->survey().complaint();
    if (!complaint.empty())
        complain(options.file.toStdString() + ": " + complaint);
    mission::ReplayRunner runner(*std::move(recording), options);
    QObject::connect(&runner, &mission::ReplayRunner::finished, qApp, [](int code) { QCoreApplication::exit(code); });
    server::QuitSignals signals_;
    QObject::connect(&signals_, &server::QuitSignals::quit, &runner, &mission::ReplayRunner::interrupt);
    QTimer progress;
    QObject::connect(&progress, &QTimer::timeout, [&runner] {
        const link::ReplayFigures figures = runner.figures();
        std::fprintf(stderr, "\r%s of %s s\x1b[K", fixed(figures.position.count(), 1).c_str(),
                     fixed(figures.span.count(), 1).c_str());
    });
    const bool shows_progress = ::isatty(STDERR_FILENO) == 1;
    if (shows_progress)
        progress.start(200);
    runner.start();
    const int exit_code = QCoreApplication::exec();
    if (shows_progress)
        std::fprintf(stderr, "\r\x1b[K");
    return end(exit_code, runner.summary());
}

int replayOrConvert(const QStringList& arguments, const mission::VerbStreams& streams) {
    const auto options = mission::readReplayOptions(arguments);
    if (!options) {
        complain(options.error().text());
        return mission::BadInput;
    }
    if (options->help) {
        std::printf("%s", qPrintable(mission::replayHelp().trimmed() + '\n'));
        return mission::Done;
    }
    return options->verb == mission::ReplayVerb::Replay ? replay(*options)
                                                        : mission::convertRecording(*options, streams);
}

} // namespace

std::optional<int> runVerb(const QStringList& arguments) {
    const bool reports = mission::isReportVerb(arguments.value(0));
    if (!reports && !mission::isReplayVerb(arguments.value(0)))
        return std::nullopt;
    QFile input, output;
    if (!input.open(stdin, QIODevice::ReadOnly) || !output.open(stdout, QIODevice::WriteOnly)) {
        complain("standard input or output cannot be opened");
        return mission::BadInput;
    }
    const mission::VerbStreams streams{input, output, complain};
    const int exit_code = reports ? mission::runReportVerb(arguments, server::pluginFolders(), streams)
                                  : replayOrConvert(arguments, streams);
    if (output.flush())
        return exit_code;
    complain(Error{"the output takes no more", "standard output", "Make room, or write elsewhere"}.text());
    return mission::BadInput;
}

} // namespace usar::app
