// Desk for results: tells how a mission ended in a card above the map, and which files were written.
#pragma once

#include <set>

#include <QThreadPool>

#include "app/desks/desk.h"
#include "core/mission/runs/run_summary.h"

namespace usar::app {

/// GUI thread; pictures are read in a pool.
class ResultDesk : public Desk {
    Q_OBJECT
public:
    using Desk::Desk;

    void wire() override;
    /// A behavior has started on this robot: its last result is over.
    void forget(RobotId id);

private:
    /// Tells the end of a behavior that has scanned nothing; the end of another one is told when its files are written.
    void takeEnd(RobotId id);
    void takeResults(RobotId id, const mission::RunSummary& summary, const QString& robot_name);
    void show(RobotId id, const widgets::MissionOutcome& outcome);
    void flyAgain();

    std::set<RobotId> ended_; ///< robots whose behavior has ended, and whose files are not written yet
    RobotId shown_;           ///< the robot of the card; 0: none, or it is gone
    QThreadPool pool_;        ///< its destructor waits
};

} // namespace usar::app
