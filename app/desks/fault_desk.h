// Desk of the faults dock: makes things go wrong in the embedded simulator on request.
#pragma once

#include <vector>

#include <QObject>

#include "app/desks/desk.h"

namespace usar::app {

/// Lists the simulator's faults, and adds and ends them. GUI thread.
class FaultDesk : public QObject {
    Q_OBJECT
public:
    explicit FaultDesk(const DeskContext& context) : desk_(context) {}

    void registerCommands();
    /// To be called after all commands are registered.
    void wire();
    /// Adds a mission's faults (texts in the syntax of --fault), with times relative to now. Equal faults of an earlier
    /// start that are not over are ended first, because two winds would blow twice as hard.
    void begin(const QStringList& faults);

private:
    /// Adds the fault that is set up in the panel.
    void inject();
    /// Enables the panel while the embedded simulator runs, and fills its lists of robots and sensors.
    void showChoices();
    void list(const std::vector<sim::FaultStatus>& faults);

    DeskContext desk_;
    std::vector<sim::FaultStatus> faults_; ///< all faults of the embedded simulator, including those that are over
};

} // namespace usar::app
