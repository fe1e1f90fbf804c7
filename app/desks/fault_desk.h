// The faults dock: what goes wrong in the embedded simulator on request.
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
    /// Once commands are registered.
    void wire();
    /// Adds a mission's faults, whose times count from now. Those of an earlier start that are not over end first: two
    /// winds would blow twice as hard.
    void begin(const QStringList& faults);

private:
    void inject();
    /// Enables the panel while the embedded simulator runs, and fills its lists of robots and sensors.
    void showChoices();
    void list(const std::vector<sim::FaultStatus>& faults);

    DeskContext desk_;
    std::vector<sim::FaultStatus> faults_; ///< the embedded simulator's, over or not
};

} // namespace usar::app
