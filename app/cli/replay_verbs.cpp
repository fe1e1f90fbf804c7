#include "app/cli/replay_verbs.h"

#include <cstdio>

#include <unistd.h>

#include <QCoreApplication>
#include <QFile>
#include <QJsonDocument>
#include <QTimer>

#include "app/cli/verb_complaint.h"
#include "app/host/quit_signals.h"
#include "core/base/numbers.h"
#include "core/link/recording_text.h"
#include "core/mission/runs/mission_runner.h"
#include "core/mission/runs/replay_runner.h"

namespace usar::app {

namespace {

int end(int exit_code, const QJsonObject& summary) {
    std::printf("%s\n", QJsonDocument(summary).toJson(QJsonDocument::Compact).constData());
    return exit_code;
}

int replay(const mission::ReplayOptions& options) {
    auto recording = link::RecordingReader::open(options.file);
    if (!recording) {
        complain(recording.error());
        return end(mission::BadInput, mission::refusedReplay(options.file, recording.error().text()));
    }
    const std::string complaint = (*recording)->survey().complaint();
    if (!complaint.empty())
        std::fprintf(stderr, "usar-mission: %s: %s\n", qPrintable(options.file), complaint.c_str());
    mission::ReplayRunner runner(*std::move(recording), options);
    QObject::connect(&runner, &mission::ReplayRunner::finished, qApp, [](int code) { QCoreApplication::exit(code); });
    QuitSignals signals_;
    QObject::connect(&signals_, &QuitSignals::quit, &runner, &mission::ReplayRunner::interrupt);
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

Result<void> openOutput(const QString& name, QFile& output) {
    if (name == "-" ? output.open(stdout, QIODevice::WriteOnly)
                    : output.open(QIODevice::WriteOnly | QIODevice::NewOnly))
        return {};
    if (QFile::exists(name))
        return failure("there is a file of this name already, and it is left alone", name.toStdString(),
                       "Give the output another name");
    return failure(output.errorString().toStdString(), name.toStdString(), "Give the output another place");
}

int convert(const mission::ReplayOptions& options) {
    const bool to_text = options.verb == mission::ReplayVerb::ToText;
    QFile input(options.file);
    const bool opened = options.file == "-" ? input.open(stdin, QIODevice::ReadOnly) : input.open(QIODevice::ReadOnly);
    if (!opened)
        return complain({input.errorString().toStdString(), options.file.toStdString(), "Check the name"});
    QFile output(options.output);
    if (const auto ready = openOutput(options.output, output); !ready)
        return complain(ready.error());
    // A recording is not read in order, so it must be a file.
    const QString file = options.file == "-" ? QString("/dev/stdin") : options.file;
    const auto done =
        to_text ? link::recordingToText(file, output) : link::textToRecording(input, options.file, output);
    if (done)
        return mission::Done;
    output.close();
    if (options.output != "-")
        output.remove();
    return complain(done.error());
}

} // namespace

int runReplayVerb(const QStringList& arguments) {
    const auto options = mission::readReplayOptions(arguments);
    if (!options)
        return complain(options.error());
    if (options->help) {
        std::printf("%s", qPrintable(mission::replayHelp().trimmed() + '\n'));
        return mission::Done;
    }
    return options->verb == mission::ReplayVerb::Replay ? replay(*options) : convert(*options);
}

} // namespace usar::app
