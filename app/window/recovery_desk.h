// Desk for what a crash leaves: it marks what is being recorded, and offers what an earlier run could not end.
#pragma once

#include <memory>

#include <QThreadPool>

#include "app/desks/desk.h"
#include "core/mission/files/run_marker.h"
#include "core/mission/runs/recorded_scan.h"

namespace usar::app {

/// Its mark lies in the folder of the settings until the window is gone. GUI thread; the disk is written in a pool.
class RecoveryDesk : public Desk {
    Q_OBJECT
public:
    /// `disk` runs one job at a time, and ends before this desk.
    RecoveryDesk(const DeskContext& context, QThreadPool& disk);

    void wire() override;
    /// Marks which recordings are being written, if that has changed.
    void mark();
    /// Asks in a strip whether to open what a run recorded that was killed, or to fly the rest of its missions; asks
    /// nothing if there is no such recording. Other questions go first.
    void offer();

signals:
    /// The user wants to open a recording.
    void recordingChosen(const QString& path);
    /// The user wants to fly what is left of the mission of a recording, which has been read.
    void restChosen(const std::shared_ptr<const usar::mission::RecordedScan>& earlier);

private:
    /// Reads what the cut-off missions have scanned; `restChosen` follows for each.
    void readScans();
    /// Asks about `left_` as soon as no other question is open.
    void ask();
    /// Full paths of the recordings of all robots.
    QStringList recordings() const;

    QThreadPool& disk_;
    QString folder_;
    mission::RunMarker marker_;
    QStringList marked_;  ///< the recordings as they were marked last
    QStringList left_;    ///< what a killed run recorded, until the user has answered
    QStringList cut_off_; ///< those of them that broke off in a mission
};

} // namespace usar::app
