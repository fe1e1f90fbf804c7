#include "core/mission/reports/replay_verb.h"

#include <cstdio>
#include <utility>

#include <unistd.h>

#include <QEventLoop>
#include <QJsonDocument>
#include <QTimer>

#include "core/base/numbers.h"
#include "core/mission/runs/mission_runner.h"

namespace usar::mission {

namespace {

int end(int exit_code, const QJsonObject& summary, const VerbStreams& streams) {
    streams.output.write(QJsonDocument(summary).toJson(QJsonDocument::Compact) + '\n');
    return exit_code;
}

int replay(const ReplayOptions& options, const VerbStreams& streams, const PrepareReplay& prepare) {
    auto recording = link::RecordingReader::open(options.file);
    if (!recording) {
        streams.complain(recording.error().text());
        return end(BadInput, refusedReplay(options.file, recording.error().text()), streams);
    }
    const std::string complaint = (*recording)->survey().complaint();
    if (!complaint.empty())
        streams.complain(options.file.toStdString() + ": " + complaint);
    ReplayRunner runner(*std::move(recording), options);
    QEventLoop loop;
    QObject::connect(&runner, &ReplayRunner::finished, &loop, &QEventLoop::exit);
    prepare(runner);
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
    const int exit_code = loop.exec();
    if (shows_progress)
        std::fprintf(stderr, "\r\x1b[K");
    return end(exit_code, runner.summary(), streams);
}

} // namespace

int runReplayVerb(const QStringList& arguments, const VerbStreams& streams, const PrepareReplay& prepare) {
    const auto options = readReplayOptions(arguments);
    if (!options) {
        streams.complain(options.error().text());
        return BadInput;
    }
    if (options->verb == ReplayVerb::Replay)
        return replay(*options, streams, prepare);
    return options->verb == ReplayVerb::ToMcap ? exportRecording(*options, streams)
                                               : convertRecording(*options, streams);
}

} // namespace usar::mission
