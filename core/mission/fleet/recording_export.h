// Exports recordings as MCAP in the background.
#pragma once

#include <stop_token>

#include <QObject>
#include <QString>
#include <QThreadPool>

#include "core/base/clock.h"
#include "core/mission/runs/recording_mcap.h"

namespace usar::mission {

/// One after the other, in a thread of its own. Belongs to the GUI thread; the destructor gives up what is under way.
class RecordingExport : public QObject {
    Q_OBJECT
public:
    RecordingExport() { pool_.setMaxThreadCount(1); }
    ~RecordingExport() override;

    /// Exports the recording into the file, which is replaced if it exists; `done` or `refused` follows.
    void begin(const QString& recording, const QString& file);
    /// Gives up all that were begun; nothing of them stays on disk.
    void cancel();
    /// True from `begin` to `done` or `refused`.
    bool busy() const { return waiting_ > 0; }

signals:
    /// Of the export that is under way, in time of the replay.
    void progressed(usar::Seconds done, usar::Seconds whole);
    /// `complaint`: what is missing; empty: nothing.
    void done(const QString& file, const QString& complaint);
    void refused(const QString& reason, bool cancelled);

private:
    void end(const Result<McapSummary>& summary, const QString& file, bool cancelled);

    QThreadPool pool_;
    std::stop_source stop_;
    int waiting_ = 0; ///< exports that were begun and have not ended
};

} // namespace usar::mission
