// Plays a recording without a window and counts what it contains.
#pragma once

#include <map>
#include <memory>
#include <string>

#include <QJsonObject>
#include <QObject>

#include "core/link/replay.h"
#include "core/mission/files/replay_options.h"
#include "core/protocol/reader.h"

namespace usar::mission {

/// Plays one recording per object, through the same Reader as a live connection. `finished` is emitted once, from the
/// event loop. Runs in its owner's thread.
class ReplayRunner : public QObject, private link::ReplayTaker {
    Q_OBJECT
public:
    /// Takes over the recording; nothing is played before `start`.
    ReplayRunner(std::unique_ptr<link::RecordingReader> recording, ReplayOptions options);

    /// To be called once.
    void start();
    /// Ends the replay (Ctrl+C); the summary covers what was played.
    void interrupt() { conclude(true); }
    /// Progress of the replay, valid at any time.
    link::ReplayFigures figures() const { return replayer_.figures(); }
    /// Summary of the replay (headless.md lists the keys). Valid after `finished`. Counts only what was played.
    QJsonObject summary() const;

signals:
    /// `exit_code` is an ExitCode.
    void finished(int exit_code);

private:
    void rewound() override {}
    /// The functions below are called by the replayer, in the order of the records.
    void opened(std::string_view) override { connections_ += !quiet_; }
    void closed(std::string_view) override {}
    void line(std::string_view text, LineNumber number) override;
    void sent(const link::Record& record) override;
    void note(const link::Record& record) override { published_ += !quiet_ && record.name == "published"; }
    void quiet(bool on) override { quiet_ = on; }
    /// Ends the replay and emits `finished`; a second call has no effect.
    void conclude(bool interrupted);
    bool isDamaged() const;

    std::string path_;
    ReplayOptions options_;
    link::Replayer replayer_;
    protocol::Reader reader_;
    protocol::Segments segments_;
    std::map<std::string, qint64> types_;   ///< lines in, by type
    std::map<std::string, qint64> sources_; ///< lines out, by source
    qint64 connections_ = 0;
    qint64 lines_in_ = 0;
    qint64 lines_out_ = 0;
    qint64 published_ = 0;
    qint64 bytes_in_ = 0;
    qint64 bytes_out_ = 0;
    qint64 diagnostics_ = 0;
    LineNumber first_line_;
    LineNumber last_line_;
    bool quiet_ = false;
    bool interrupted_ = false;
    bool over_ = false;
};

/// Summary for a recording that could not be opened: the keys that are known then.
QJsonObject refusedReplay(const QString& file, const std::string& reason);

} // namespace usar::mission
